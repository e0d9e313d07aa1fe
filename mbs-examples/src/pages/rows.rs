//! Residuals of the rows, and the number of corrections.

use super::data::{Data, Table};
use super::markdown::{error, paragraph, significant};
use super::scene_runs::{FILE, start};
use crate::laboratory::store::Row;
use crate::scene::Scene;

/// Runs of the scenes with other steps, below `book/src/results`.
const OTHER_STEPS: &str = "readme/rows.csv";
/// Its columns; the first two identify a run.
pub const COLUMNS: [&str; 5] = [
    "scene",
    "step_s",
    "holonomic_error",
    "velocity_error",
    "placed_steps",
];
/// How many of them identify a run.
pub const KEYS: usize = 2;
/// Runs of a scene; steps from half to 1.25 times its own.
const RUNS: i32 = 40;
/// Samples of a run, at most.
const SAMPLES: f64 = 400.0;
/// Residuals above this, which is far above round-off, are named.
const NAMED: f64 = 1e-11;

/// Steps, s.
pub fn steps(scene: &Scene) -> impl Iterator<Item = f64> {
    let factor = 2.5_f64.powf(1.0 / f64::from(RUNS - 1));
    let own = scene.step;
    (0..RUNS).map(move |i| 0.5 * own * factor.powi(i))
}

/// A run with samples at every so-many-th step, which end steps that would go beyond.
///
/// # Errors
/// What stopped it.
pub fn run(scene: &Scene, step: f64) -> Result<Row, String> {
    let stopped = |error| format!("{} with {step:e} s: {error}", scene.name);
    let mut simulation = start(scene, step).map_err(stopped)?;
    let interval = step * (scene.duration / step / SAMPLES).ceil();
    for sample in 1..=(scene.duration / interval).ceil() as u32 {
        let time = (f64::from(sample) * interval).min(scene.duration);
        simulation.run_until(time).map_err(stopped)?;
    }
    let report = simulation.report();
    let mut row = vec![scene.name.to_owned(), format!("{step:.4e}")];
    row.extend([report.holonomic_error, report.velocity_error].map(|error| format!("{error:.2e}")));
    row.push(report.placed_steps.to_string());
    Ok(row)
}

/// The largest |φ| and |A v + b| of the runs of the table, and with other steps.
pub fn measured(data: &Data) -> Result<String, String> {
    let (own, other) = (data.table(FILE)?, data.table(OTHER_STEPS)?);
    let own = own.rows.iter().filter(|row| row[2] != "0").count();
    let sentence = |column| {
        let worst = worst(&other, column)?;
        let (named, rest): (Vec<_>, Vec<_>) = worst.iter().partition(|value| value.1 > NAMED);
        let named: Vec<String> = named
            .iter()
            .map(|(name, value, runs)| {
                format!("{} on `{name}` ({runs} of {RUNS} runs)", error(*value))
            })
            .collect();
        let rest = rest.first().ok_or("no scene is near round-off")?;
        let rest = format!("{} (`{}`)", error(rest.1), rest.0);
        Ok::<_, String>(match named.is_empty() {
            true => rest,
            false => format!("{}; elsewhere {rest}", named.join(", ")),
        })
    };
    Ok(paragraph(&format!(
        "Each of the {own} scenes with rows was run with {RUNS} values of h, from half to 1.25 times that of the table. The largest |φ|: \
         {}. The largest |A v + b|: {}. A step that is far shorter than h, such as the last one of a run, satisfies nonholonomic rows less \
         closely: their residual may be as large as a velocity that moves positions by their round-off within this step. A step of second order that ends \
         beside a singular pose leaves out a row with a pivot below 1e-9.",
        sentence("holonomic_error")?,
        sentence("velocity_error")?,
    )))
}

/// The largest value of each scene, the largest first, and how many runs have more than [`NAMED`].
fn worst<'t>(runs: &'t Table, column: &str) -> Result<Vec<(&'t str, f64, usize)>, String> {
    let mut worst: Vec<(&str, f64, usize)> = Vec::new();
    for line in runs.lines() {
        let (scene, value) = (line.text("scene")?, line.number(column)?);
        let far = usize::from(value > NAMED);
        match worst.iter_mut().find(|known| known.0 == scene) {
            Some((_, most, count)) => {
                *most = most.max(value);
                *count += far;
            }
            None => worst.push((scene, value, far)),
        }
    }
    worst.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(worst)
}

/// Corrections of κ₁ a step.
pub fn corrections(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let line = results.find(&[("scene", "double-four-bar")])?;
    let count = line.number("iterations")? / line.number("stages")?;
    Ok(significant(count, 2))
}
