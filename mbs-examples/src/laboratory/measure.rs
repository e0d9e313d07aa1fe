//! One run: its outcome, its errors, and its processor time.

use cpu_time::ProcessTime;
use mbs_runtime::{AnySimulation, SimulationError};

use super::methods::Entry;
use super::outcome::{ASTRAY, Outcome};
use super::yardstick::{INSTANTS, Yardstick, frame, worse};

/// The errors of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Errors {
    /// Its outcome.
    pub outcome: Outcome,
    /// Processor time until it ended, comparisons included, s.
    pub cpu: f64,
    /// Steps taken.
    pub steps: u64,
    /// The largest position error over the instants, m or rad.
    pub position: f64,
    /// max |energy error| over all steps, J.
    pub energy: f64,
    /// The largest error of a reaction over the instants, relative to the largest reaction.
    pub reaction: f64,
    /// Why it ended early.
    pub detail: String,
}

impl Errors {
    /// For a run without numbers.
    fn of(outcome: Outcome, detail: String) -> Self {
        Errors {
            outcome,
            cpu: 0.0,
            steps: 0,
            position: f64::NAN,
            energy: f64::NAN,
            reaction: f64::NAN,
            detail,
        }
    }
}

/// Runs to the end of the yardstick and compares; stops after `patience` seconds of processor time.
pub fn errors(yardstick: &Yardstick, entry: &Entry, control: f64, patience: f64) -> Errors {
    let mut errors = Errors::of(Outcome::Ok, String::new());
    let mut simulation = match yardstick.build(entry, control) {
        Ok(simulation) => simulation,
        Err(error) => {
            errors.outcome = Outcome::of_error(&error);
            errors.detail = error.to_string();
            return errors;
        }
    };
    let start = ProcessTime::now();
    let (mut frames, mut reaction) = (Vec::new(), 0.0);
    for i in 1..=INSTANTS {
        if let Err(error) = simulation.run_until(yardstick.instant(i)) {
            errors.outcome = Outcome::of_error(&error);
            errors.detail = error.to_string();
            break;
        }
        if start.elapsed().as_secs_f64() > patience {
            errors.outcome = Outcome::TooSlow;
            errors.detail = format!("given up after {patience} s at t = {} s", simulation.time());
            break;
        }
        frames.push(frame(simulation.time(), simulation.output_values()));
        reaction = worse(reaction, reaction_error(yardstick, i, simulation.as_ref()));
    }
    let report = simulation.report();
    errors.cpu = start.elapsed().as_secs_f64();
    errors.steps = report.steps;
    let largest = yardstick.distance(&frames);
    if errors.outcome == Outcome::Ok {
        errors.position = largest;
        errors.energy = report.energy_error;
        errors.reaction = match largest_reaction(yardstick) > 0.0 {
            true => reaction,
            false => f64::NAN,
        };
        if !(largest <= ASTRAY * yardstick.size) {
            errors.outcome = Outcome::WrongBranch;
            errors.detail = format!("{largest:.1e} from the reference");
        }
    }
    errors
}

/// The largest reaction of all instants; 0 where there is nothing to compare.
fn largest_reaction(yardstick: &Yardstick) -> f64 {
    let all = yardstick.reactions.iter().flatten();
    all.fold(0.0, |most: f64, r| most.max(r.abs()))
}

/// Relative to the largest reaction.
fn reaction_error(yardstick: &Yardstick, i: u32, simulation: &dyn AnySimulation) -> f64 {
    let Some(wanted) = yardstick.reactions.get(i as usize - 1) else {
        return 0.0;
    };
    let scale = largest_reaction(yardstick);
    if scale == 0.0 {
        return 0.0;
    }
    let Ok(found) = simulation.reactions() else {
        return f64::INFINITY;
    };
    let pairs = found.values.iter().zip(wanted);
    pairs.fold(0.0, |most, (a, b)| worse(most, (a - b).abs() / scale))
}

/// Processor time of such a run with its energy balance, s; assembly, the choice of a method by an accuracy, sampling and
/// comparing are not part of it.
///
/// # Errors
/// As the run.
pub fn time(yardstick: &Yardstick, entry: &Entry, control: f64) -> Result<f64, SimulationError> {
    let mut simulation = yardstick.build(entry, control)?;
    let start = ProcessTime::now();
    for i in 1..=INSTANTS {
        simulation.run_until(yardstick.instant(i))?;
    }
    Ok(start.elapsed().as_secs_f64())
}
