//! Ten seconds through singular poses at every order.

use mbs_runtime::output::Frame;
use mbs_runtime::{Report, Settings};

use super::data::{Data, Line};
use super::markdown::{error, paragraph, table as markdown, thousands};
use crate::reference::ReferenceTable;
use crate::scene::Scene;
use crate::scenes::{double_four_bar, slider_crank};

/// Runs with steps of the table, below `book/src/results`.
pub const FILE: &str = "readme/orders.csv";
/// Its columns; the first five identify a run.
pub const COLUMNS: [&str; 10] = [
    "scene",
    "order",
    "placement",
    "step_s",
    "interval_s",
    "stages",
    "iterations",
    "placed_steps",
    "energy_error_J",
    "position_error_m",
];
/// How many of them identify a run.
pub const KEYS: usize = 5;
/// Runs with random steps.
pub const RANDOM: &str = "readme/passages.csv";

/// The scenes, with the columns of their references that are positions.
pub const SCENES: [(&Scene, &[&str]); 2] = [
    (&slider_crank::SCENE, &["p1x_m", "p1y_m", "p2x_m"]),
    (&double_four_bar::SCENE, &["b0x_m", "b0y_m"]),
];
/// s
pub const DURATION: f64 = 10.0;
/// Times between samples, which end steps: of these runs, and of `mbs simulate` with steps of 0.025 s; s.
pub const INTERVALS: [f64; 2] = [0.5, 0.05];
const STEP: &str = "2.5e-2";
const ORDERS: [&str; 3] = ["4", "6", "8"];

/// How a run ended.
#[derive(Debug)]
pub struct Outcome {
    /// Its counts and its energy error.
    pub report: Report,
    /// Largest error of the named columns, m; `None` if the run stopped.
    pub position: Option<f64>,
}

/// Runs a scene, with a sample every `interval`.
pub fn run(
    (scene, columns): (&Scene, &[&str]),
    reference: &ReferenceTable,
    settings: Settings,
    interval: f64,
) -> Outcome {
    let mut outcome = Outcome {
        report: Report::default(),
        position: None,
    };
    let Ok(mut simulation) = (scene.build)(&[], settings) else {
        return outcome;
    };
    let mut frames = Vec::new();
    for instant in 0..=(DURATION / interval).round() as u32 {
        let done = simulation.run_until(f64::from(instant) * interval);
        outcome.report = simulation.report();
        if done.is_err() {
            return outcome;
        }
        frames.push(Frame::record(simulation.as_ref()));
    }
    let deviations = reference.compare(&frames);
    let named = deviations
        .iter()
        .filter(|deviation| columns.contains(&deviation.column));
    let worse = |most: f64, e: f64| if e > most || e.is_nan() { e } else { most };
    outcome.position = Some(named.map(|deviation| deviation.largest).fold(0.0, worse));
    outcome
}

fn yes(placement: bool) -> &'static str {
    if placement { "yes" } else { "no" }
}

/// The row of a run.
pub fn row(scene: &Scene, settings: &Settings, interval: f64, outcome: &Outcome) -> Vec<String> {
    let report = outcome.report;
    vec![
        scene.name.to_owned(),
        settings.order.to_string(),
        yes(settings.placement).to_owned(),
        format!("{:e}", settings.step),
        format!("{interval:e}"),
        report.stages.to_string(),
        report.iterations.to_string(),
        report.placed_steps.to_string(),
        format!("{:.4e}", report.energy_error),
        outcome
            .position
            .map_or("stopped".to_owned(), |error| format!("{error:.4e}")),
    ]
}

/// The README's table of orders.
pub fn table(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 7] = [
        "scene",
        "order",
        "stages",
        "energy error, J",
        "position error, m",
        "worst energy error, J",
        "the same with `placement: false`",
    ];
    let (fixed, random) = (data.table(FILE)?, data.table(RANDOM)?);
    let mut rows = Vec::new();
    for (scene, _) in SCENES {
        for order in ORDERS {
            let key = [("scene", scene.name), ("order", order)];
            let keys = |more: &[(&'static str, &'static str)]| [&key, more].concat();
            let interval = [
                ("placement", "yes"),
                ("step_s", STEP),
                ("interval_s", "5e-1"),
            ];
            let line = fixed.find(&keys(&interval))?;
            let mut row = vec![
                match order {
                    "4" => format!("`{}`", scene.name),
                    _ => String::new(),
                },
                order.to_owned(),
                line.text("stages")?.to_owned(),
            ];
            row.push(error(line.number("energy_error_J")?));
            row.push(error(line.number("position_error_m")?));
            for placement in ["yes", "no"] {
                let method = ("method", "two-level");
                let line = random.find(&keys(&[method, ("placement", placement)]))?;
                row.push(error(line.number("energy_error_worst_J")?));
            }
            rows.push(row);
        }
    }
    Ok(markdown(&HEADING, &rows))
}

/// The effect of more samples.
pub fn samples(data: &Data) -> Result<String, String> {
    let runs = data.table(FILE)?;
    let line = |interval| {
        runs.find(&[
            ("scene", slider_crank::SCENE.name),
            ("order", "6"),
            ("placement", "yes"),
            ("step_s", STEP),
            ("interval_s", interval),
        ])
    };
    let says = |line: Line| {
        Ok::<_, String>(format!(
            "{} stages, with a position error of {} m",
            thousands(line.number("stages")?),
            error(line.number("position_error_m")?)
        ))
    };
    Ok(paragraph(&format!(
        "A sample is an instant at which results are recorded. Without a tolerance a step ends at each sample, and after a step whose \
         length was changed by placement the last step before the sample is shorter: so a run depends on its samples. `mbs simulate \
         slider-crank --order 6 --step 0.025`, with a sample every 0.05 s, takes {}; the same with a sample every 0.5 s takes {}.",
        says(line("5e-2")?)?,
        says(line("5e-1")?)?,
    )))
}
