//! The double four-bar.

use mbs_runtime::{Method, ProjectionSettings};

use super::column::Column;
use super::figure3::PENALTIES;
use super::run::{DOUBLE_FOUR_BAR, Extent, METHODS, PAPER, Run, STEP, TWO_LEVEL, methods};
use super::{Curve, Figure, Panel, Scale};

/// The benchmark solution of the paper.
pub const BENCHMARK: &str = "index3-projections";

/// All methods and the benchmark, over ten seconds finely and then coarsely to the end.
pub fn runs(extent: Extent, end: f64) -> Vec<Run> {
    let mut instants = extent.instants(0.0, 10.0, 250);
    instants.extend(extent.instants(10.0, end, 180));
    let mut runs = methods(PENALTIES[0], STEP, &instants);
    let method = Method::Index3Projections(ProjectionSettings::default());
    runs.push(Run::new(BENCHMARK, method, STEP, &instants));
    runs
}

/// Components of a point by three methods.
pub fn components(
    title: &'static str,
    axis: &'static str,
    columns: &[(Column, &str)],
    window: [f64; 2],
) -> Panel {
    let mut curves = Vec::new();
    for run in [TWO_LEVEL, BENCHMARK, PAPER] {
        for &(column, name) in columns {
            let label = format!("{run}, {name}");
            curves.push(Curve { label, run, column });
        }
    }
    Panel::over_time(title, axis, curves, window, Scale::Linear)
}

pub fn figure(extent: Extent) -> Figure {
    let place = [(Column::Output("p1.x"), "x"), (Column::Output("p1.y"), "y")];
    let velocity = [
        (Column::Output("p1_velocity.x"), "x"),
        (Column::Output("p1_velocity.y"), "y"),
    ];
    let first = [0.0, extent.time(10.0)];
    let all = [&METHODS[..], &[BENCHMARK]].concat();
    let energy = |title, window, scale| {
        let axis = "energy error, J";
        Panel::of_runs(title, axis, Column::EnergyError, &all, window, scale)
    };
    Figure {
        number: 6,
        title: "double four-bar, 36 velocities and 36 rows",
        subject: &DOUBLE_FOUR_BAR,
        columns: [
            vec![Column::EnergyError, Column::Output("branch")],
            place.map(|p| p.0).to_vec(),
            velocity.map(|p| p.0).to_vec(),
        ]
        .concat(),
        runs: runs(extent, 100.0),
        panels: vec![
            components("position of P₁", "m", &place, first),
            components("velocity of P₁", "m/s", &velocity, first),
            energy(
                "error of the mechanical energy",
                first,
                Scale::Between(-1.0, 0.2),
            ),
            energy(
                "the same, longer",
                [0.0, extent.time(100.0)],
                Scale::Between(-30.0, 6.0),
            ),
        ],
    }
}
