//! A run from many starts: an outcome that differs between starts 1e-13 apart depends on round-off.

use std::io;

use mbs_runtime::Settings;

use super::run::{Extent, Run, Source, Subject};
use super::{Figure, stamp};
use crate::laboratory::outcome::Outcome;
use crate::laboratory::store::{Row, Store};

/// The columns of the file; the first two identify a row.
pub const ENSEMBLE_COLUMNS: [&str; 7] = [
    "run",
    "member",
    "outcome",
    "reached_s",
    "rejected",
    "energy_error_J",
    "largest_branch",
];
/// How many of them identify a row.
pub const ENSEMBLE_KEYS: usize = 2;
/// The relative difference of the lengths of the mechanism between one start and the next.
const APART: f64 = 1e-13;
/// Duration of each run, s.
const END: f64 = 20.0;
/// Number of instants at which a run is tested.
const LOOKS: u32 = 200;
/// A run is stopped if it gains more energy than this, J.
const MOST: f64 = 1e3;

/// Makes the runs that the store does not have yet.
///
/// # Errors
/// A file that cannot be written.
pub fn measure_ensemble(
    figure: &Figure,
    extent: Extent,
    store: &mut Store,
    tick: &mut dyn FnMut(&'static str),
) -> io::Result<()> {
    let wanted = |run: &&Run| figure.ensemble.contains(&run.label);
    for run in figure.runs.iter().filter(wanted) {
        let Source::Simulated(settings) = run.source else {
            continue;
        };
        let subject = run.subject.unwrap_or(figure.subject);
        let end = extent.time(END);
        for member in 0..extent.members {
            tick(run.label);
            let name = member.to_string();
            if store.find(&[run.label, &name]).is_some() {
                continue;
            }
            let size = 1.0 + APART * (f64::from(member) - 0.5 * f64::from(extent.members));
            let mut row = vec![run.label.to_owned(), name];
            row.extend(follow(subject, settings, size, end, extent));
            store.put(row)?;
        }
    }
    store.compact()
}

/// The end of one run.
fn follow(subject: &Subject, settings: Settings, size: f64, end: f64, extent: Extent) -> Row {
    let mut probe = match (subject.build)(settings, size) {
        Ok(probe) => probe,
        Err(error) => {
            let mut row = vec![String::new(); ENSEMBLE_COLUMNS.len() - ENSEMBLE_KEYS];
            row[0] = Outcome::of_error(&error).name().to_owned();
            return row;
        }
    };
    let outputs = subject.model.outputs;
    let branch = outputs.iter().position(|output| output.name == "branch");
    let start = cpu_time::ProcessTime::now();
    let (mut outcome, mut astray): (Outcome, f64) = (Outcome::Ok, 0.0);
    for look in 1..=LOOKS {
        if let Err(error) = probe.run_until(end * f64::from(look) / f64::from(LOOKS)) {
            outcome = Outcome::of_error(&error);
            break;
        }
        if let Some(branch) = branch {
            astray = astray.max(probe.outputs()[branch].abs());
        }
        if !(probe.energy().error.abs() <= MOST) {
            outcome = Outcome::EnergyGrowth;
            break;
        }
        if start.elapsed().as_secs_f64() > extent.patience {
            outcome = Outcome::TooSlow;
            break;
        }
    }
    let report = probe.report();
    vec![
        outcome.name().to_owned(),
        stamp(probe.time()),
        report.rejected_steps.to_string(),
        format!("{:.2e}", probe.energy().error),
        format!("{astray:.1e}"),
    ]
}
