//! The figures of the paper (Potosakis, Paraskevopoulos, Natsiavas 2020, section 7) with our code: the same mechanisms
//! with as many coordinates and rows, the same axes, and other methods beside that of the paper.
//!
//! A [`Figure`] is a plan of [`Run`]s and [`Panel`]s; [`measure`] makes the runs that the files do not have yet, and
//! [`draw`] makes the picture from the files.

mod column;
mod draw;
mod ensemble;
mod exact;
mod figure1;
mod figure2;
mod figure3;
mod figure4;
mod figure5;
mod figure6;
mod figure7;
mod look;
mod probe;
mod record;
mod report;
mod run;
mod sketch;

pub use column::Column;
pub use draw::draw;
pub use ensemble::{ENSEMBLE_COLUMNS, ENSEMBLE_KEYS, measure_ensemble};
pub use figure1::EXACT;
pub use probe::{Instant, Probe};
pub use record::{RUN_COLUMNS, RUN_KEYS, SAMPLE_KEYS, Stores, measure};
pub use report::{COMPARED, ensemble_table, run_table};
pub use run::{Extent, Run, Source, Subject};
pub use sketch::Sketch;

/// One figure.
pub struct Figure {
    /// That of the paper.
    pub number: u8,
    /// For people.
    pub title: &'static str,
    /// Text beside the mechanism: settings of all runs.
    pub caption: &'static [&'static str],
    /// The mechanism.
    pub subject: &'static Subject,
    /// The columns of each run, without the time.
    pub columns: Vec<Column>,
    /// The runs.
    pub runs: Vec<Run>,
    /// Labels of the runs that are also made from many starts.
    pub ensemble: &'static [&'static str],
    /// The pictures.
    pub panels: Vec<Panel>,
}

/// One diagram of a figure.
pub struct Panel {
    /// For people.
    pub title: &'static str,
    /// Of x; of time if there is none.
    pub across: Option<Column>,
    /// At the axes.
    pub axes: [&'static str; 2],
    /// What is drawn.
    pub curves: Vec<Curve>,
    /// The part of the abscissa that is drawn.
    pub window: [f64; 2],
    /// The ordinate.
    pub scale: Scale,
}

/// One curve of a panel.
pub struct Curve {
    /// In the legend.
    pub label: String,
    /// Of which run.
    pub run: &'static str,
    /// What of it.
    pub column: Column,
}

/// An ordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scale {
    /// From the least value to the largest.
    Linear,
    /// Between these; curves leave it.
    Between(f64, f64),
    /// Decades of magnitudes, not below the first, not beyond the second.
    Decades(i32, i32),
}

impl Panel {
    /// One curve of each of these runs, over time.
    fn of_runs(
        title: &'static str,
        axis: &'static str,
        column: Column,
        runs: &[&'static str],
        window: [f64; 2],
        scale: Scale,
    ) -> Self {
        let curve = |&run: &&'static str| Curve {
            label: run.to_owned(),
            run,
            column,
        };
        let curves = runs.iter().map(curve).collect();
        Panel::over_time(title, axis, curves, window, scale)
    }

    /// Any curves over time.
    fn over_time(
        title: &'static str,
        axis: &'static str,
        curves: Vec<Curve>,
        window: [f64; 2],
        scale: Scale,
    ) -> Self {
        Panel {
            title,
            across: None,
            axes: ["time, s", axis],
            curves,
            window,
            scale,
        }
    }

    /// Several columns of one run, over time.
    fn of_columns(
        title: &'static str,
        axis: &'static str,
        run: &'static str,
        columns: &[(Column, &str)],
        window: [f64; 2],
        scale: Scale,
    ) -> Self {
        let curve = |&(column, label): &(Column, &str)| Curve {
            label: label.to_owned(),
            run,
            column,
        };
        let curves = columns.iter().map(curve).collect();
        Panel::over_time(title, axis, curves, window, scale)
    }
}

/// All figures, or those of the quick form: shorter runs.
pub fn figures(extent: Extent) -> Vec<Figure> {
    vec![
        figure1::figure(extent),
        figure2::figure(extent),
        figure3::figure(extent),
        figure4::figure(extent),
        figure5::figure(extent),
        figure6::figure(extent),
        figure7::figure(extent),
    ]
}

/// A time in the form of the files, s: to a tenth of a microsecond.
fn stamp(time: f64) -> String {
    format!("{}", (1e7 * time).round() / 1e7)
}
