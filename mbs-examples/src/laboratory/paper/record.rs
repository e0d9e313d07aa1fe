//! Makes the runs of a figure and stores their results.

use std::io;

use cpu_time::ProcessTime;
use mbs_runtime::Settings;

use super::column::{Column, Numbers};
use super::probe::Probe;
use super::run::{Extent, Run, Source, Subject};
use super::{Figure, stamp};
use crate::laboratory::outcome::Outcome;
use crate::laboratory::store::{Row, Store};

/// The columns of the file of runs; the first identifies a run.
pub const RUN_COLUMNS: [&str; 14] = [
    "run",
    "settings",
    "outcome",
    "reached_s",
    "steps",
    "stages",
    "rejected",
    "energy_error_J",
    "largest_energy_error_J",
    "largest_phi",
    "largest_rate",
    "largest_branch",
    "cpu_s",
    "detail",
];
/// How many of them identify a run.
pub const RUN_KEYS: usize = 1;
/// The run and the time identify a sample.
pub const SAMPLE_KEYS: usize = 2;
/// A run is stopped when a row is violated by this, m or rad: the mechanisms have rods of 1 m.
const APART: f64 = 0.1;
/// As fractions of a step: a remainder that counts as no step, and the longest length that counts as one step.
/// Placement lengthens a step up to 1.15.
const LEAST: f64 = 1e-6;
const MOST: f64 = 1.2;

/// The two files of a figure.
pub struct Stores {
    /// One row for each run and instant.
    pub samples: Store,
    /// One row for each run.
    pub runs: Store,
}

impl Figure {
    /// The columns of the file of samples.
    pub fn sample_columns(&self) -> Vec<String> {
        let fixed = ["run".to_owned(), "time_s".to_owned()];
        fixed
            .into_iter()
            .chain(self.columns.iter().map(Column::name))
            .collect()
    }

    /// Number of instants to record.
    pub fn points(&self) -> usize {
        self.runs.iter().map(|run| run.instants.len()).sum()
    }
}

/// Makes the runs that the stores do not have yet; `tick` is called for each instant, with the run.
///
/// # Errors
/// A file that cannot be written.
pub fn measure(
    figure: &Figure,
    extent: Extent,
    stores: &mut Stores,
    tick: &mut dyn FnMut(&'static str),
) -> io::Result<()> {
    for run in &figure.runs {
        if stores.runs.find(&[run.label]).is_some() {
            run.instants.iter().for_each(|_| tick(run.label));
            continue;
        }
        let mut samples = Vec::new();
        let row = match run.source {
            Source::Exact(motion) => {
                for &time in &run.instants {
                    let value = |column: &Column| motion(time, column);
                    samples.push((time, figure.columns.iter().map(value).collect()));
                    tick(run.label);
                }
                exact_row(run)
            }
            Source::Simulated(settings) => {
                let subject = run.subject.unwrap_or(figure.subject);
                simulate(figure, run, subject, settings, extent, &mut samples, tick)
            }
        };
        for (time, values) in samples {
            let cells = values
                .iter()
                .map(|value| value.map_or(String::new(), |value| format!("{value:.4e}")));
            let row = [run.label.to_owned(), stamp(time)];
            stores.samples.put(row.into_iter().chain(cells).collect())?;
        }
        // Written last, so that an interrupted run is repeated.
        stores.runs.put(row)?;
    }
    stores.samples.compact()?;
    stores.runs.compact()
}

type Samples = Vec<(f64, Vec<Option<f64>>)>;

fn simulate(
    figure: &Figure,
    run: &Run,
    subject: &Subject,
    settings: Settings,
    extent: Extent,
    samples: &mut Samples,
    tick: &mut dyn FnMut(&'static str),
) -> Row {
    let start = ProcessTime::now();
    let mut probe = match (subject.build)(settings, 1.0) {
        Ok(probe) => probe,
        Err(error) => return plain_row(run, Outcome::of_error(&error), &error.to_string()),
    };
    let branch = subject
        .model
        .outputs
        .iter()
        .position(|output| output.name == "branch");
    let mut numbers = Numbers::new(&figure.columns);
    let by_steps = figure.columns.iter().any(Column::is_of_steps);
    let compares = figure.columns.iter().any(Column::is_of_a_force);
    let mut astray: f64 = 0.0;
    let (mut outcome, mut detail) = (Outcome::Ok, String::new());
    samples.push((0.0, numbers.look(probe.as_ref())));
    for &instant in &run.instants {
        tick(run.label);
        if outcome != Outcome::Ok {
            continue;
        }
        let mut stride = || -> Result<(), mbs_runtime::SimulationError> {
            if !by_steps {
                let last = instant - settings.step;
                if !compares || last <= probe.time() {
                    return probe.run_until(instant);
                }
                probe.run_until(last)?;
                let before = probe.instant();
                probe.run_until(instant)?;
                numbers.step(probe.as_ref(), Some(&before));
                return Ok(());
            }
            // Whole steps, each recorded, and then the remainder up to the instant.
            while instant - probe.time() > LEAST * settings.step {
                let before = compares.then(|| probe.instant());
                match instant - probe.time() > MOST * settings.step {
                    true => probe.step()?,
                    false => probe.run_until(instant)?,
                }
                numbers.step(probe.as_ref(), before.as_ref());
            }
            probe.run_until(instant)?;
            Ok(())
        };
        if let Err(error) = stride() {
            outcome = Outcome::of_error(&error);
            detail = error.to_string();
        }
        if let Some(branch) = branch {
            astray = astray.max(probe.outputs()[branch].abs());
        }
        let values = numbers.look(probe.as_ref());
        samples.push((probe.time(), values));
        let violation = probe.report().holonomic_error;
        if outcome == Outcome::Ok && !(violation <= APART) {
            outcome = Outcome::Drift;
            detail = format!("a row is violated by {violation:.2}");
        }
        if outcome == Outcome::Ok && start.elapsed().as_secs_f64() > extent.patience {
            outcome = Outcome::TooSlow;
            detail = format!("given up after {} s", extent.patience);
        }
    }
    row(run, outcome, &detail, probe.as_ref(), astray, start)
}

fn row(
    run: &Run,
    outcome: Outcome,
    detail: &str,
    probe: &dyn Probe,
    astray: f64,
    start: ProcessTime,
) -> Row {
    let report = probe.report();
    vec![
        run.label.to_owned(),
        run.settings(),
        outcome.name().to_owned(),
        stamp(probe.time()),
        report.steps.to_string(),
        report.stages.to_string(),
        report.rejected_steps.to_string(),
        format!("{:.4e}", probe.energy().error),
        format!("{:.4e}", report.energy_error),
        format!("{:.4e}", report.holonomic_error),
        format!("{:.4e}", report.velocity_error),
        format!("{astray:.4e}"),
        format!("{:.2}", start.elapsed().as_secs_f64()),
        detail.to_owned(),
    ]
}

/// The row of a run that did not begin.
fn plain_row(run: &Run, outcome: Outcome, detail: &str) -> Row {
    let mut row = vec![String::new(); RUN_COLUMNS.len()];
    row[0] = run.label.to_owned();
    row[1] = run.settings();
    row[2] = outcome.name().to_owned();
    row[3] = "0".to_owned();
    row[13] = detail.to_owned();
    row
}

fn exact_row(run: &Run) -> Row {
    let mut row = plain_row(run, Outcome::Ok, "closed form");
    row[3] = stamp(run.instants.last().copied().unwrap_or(0.0));
    row
}
