//! Runs the cells of a map and finds their outcomes, by the criteria of [`super::super::outcome`].

use std::collections::HashMap;
use std::io;

use cpu_time::ProcessTime;
use mbs_runtime::{AnySimulation, SimulationError};

use super::super::outcome::{ASTRAY, DRIFT, ENERGY, Outcome};
use super::super::store::{Row, Store};
use super::motion::Motion;
use super::{Course, Map, Problem, Trial};

/// Number of instants at which a run is tested.
pub(super) const LOOKS: u32 = 200;

/// Measures the cells of a map that the store does not have yet; a run is stopped after `patience` seconds of processor
/// time.
///
/// # Errors
/// A file that cannot be written.
pub fn measure(
    map: &Map,
    patience: f64,
    store: &mut Store,
    tick: &mut dyn FnMut(),
) -> io::Result<()> {
    let mut motions: HashMap<String, Motion> = HashMap::new();
    for (j, column) in map.columns.iter().enumerate() {
        for (i, row) in map.rows.iter().enumerate() {
            let key = [map.name, row, &format!("{column:e}")];
            if store.find(&key).is_none() {
                store.put(cell(key, (map.trials)(i, j), patience, &mut motions))?;
            }
            tick();
        }
    }
    store.compact()
}

fn cell(
    key: [&str; super::KEYS],
    trials: Vec<Trial>,
    patience: f64,
    motions: &mut HashMap<String, Motion>,
) -> Row {
    let start = ProcessTime::now();
    let mut ends: Vec<End> = Vec::new();
    for trial in &trials {
        let end = run(trial, patience, motions);
        let useless = matches!(end.outcome, Outcome::TooSlow | Outcome::Refused);
        ends.push(end);
        if useless {
            break;
        }
    }
    let failures: Vec<&End> = ends.iter().filter(|e| e.outcome.is_failure()).collect();
    let count = |outcome: Outcome| failures.iter().filter(|e| e.outcome == outcome).count();
    let frequent = failures.iter().map(|e| e.outcome).max_by_key(|&o| count(o));
    let last = ends.last().map_or(Outcome::Refused, |end| end.outcome);
    let told = failures.first().copied().or(ends.last());
    let words = told.map_or(String::new(), |end| end.words.clone());
    let stopped = failures.iter().filter(|end| end.stopped).count();
    let mut row: Row = key.iter().map(|&cell| cell.to_owned()).collect();
    row.extend([
        frequent.unwrap_or(last).name().to_owned(),
        ends.len().to_string(),
        failures.len().to_string(),
        stopped.to_string(),
        format!("{:.3e}", start.elapsed().as_secs_f64()),
        words,
    ]);
    row
}

/// The end of a run.
struct End {
    outcome: Outcome,
    /// If it failed.
    words: String,
    /// Whether it ended with an error of its own.
    stopped: bool,
}

impl End {
    fn with(outcome: Outcome, words: String) -> Self {
        End {
            outcome,
            words,
            stopped: false,
        }
    }

    fn stopped(error: &SimulationError) -> Self {
        End {
            outcome: Outcome::of_error(error),
            words: error.to_string(),
            stopped: true,
        }
    }
}

fn run(trial: &Trial, patience: f64, motions: &mut HashMap<String, Motion>) -> End {
    let problem = &trial.problem;
    let mut simulation = match problem.build(trial.settings) {
        Ok(simulation) => simulation,
        // Nothing has moved.
        Err(error) => return End::with(Outcome::Refused, error.to_string()),
    };
    let key = problem.key();
    if !motions.contains_key(&key) {
        match Motion::new(problem) {
            Ok(motion) => motions.insert(key.clone(), motion),
            Err(error) => return End::with(Outcome::Refused, format!("no right motion: {error}")),
        };
    }
    let motion = &motions[&key];
    let start = ProcessTime::now();
    for look in 1..=LOOKS {
        if let Err(error) = advance(trial, simulation.as_mut(), look) {
            return End::stopped(&error);
        }
        if let Some((outcome, words)) = judge(simulation.as_ref(), motion) {
            return End::with(outcome, words);
        }
        if start.elapsed().as_secs_f64() > patience {
            let words = format!("given up at t = {} s", simulation.time());
            return End::with(Outcome::TooSlow, words);
        }
    }
    End::with(Outcome::Ok, String::new())
}

/// From one instant at which a run is tested to the next.
fn advance(
    trial: &Trial,
    simulation: &mut dyn AnySimulation,
    look: u32,
) -> Result<(), SimulationError> {
    let problem = &trial.problem;
    let instant = |look: u32| problem.duration * f64::from(look) / f64::from(LOOKS);
    let until = instant(look);
    jump(problem, simulation, look - 1)?;
    match trial.course {
        Course::Whole if simulation.time() >= until => Ok(()),
        Course::Whole => simulation.run_past(until, problem.duration),
        Course::Instants => simulation.run_until(until),
        Course::Pieces(piece) => {
            let mut count = (instant(look - 1) / piece).floor() + 1.0;
            while count * piece < until {
                simulation.run_until(count * piece)?;
                count += 1.0;
            }
            simulation.run_until(until)
        }
    }
}

/// Gives the input of a problem, if it has one, its value after this instant.
pub(super) fn jump(
    problem: &Problem,
    simulation: &mut dyn AnySimulation,
    look: u32,
) -> Result<(), SimulationError> {
    match problem.jumps {
        Some((name, size)) => simulation.set_input(name, size * (13.0 * f64::from(look)).sin()),
        None => Ok(()),
    }
}

/// The failure of a run at this instant, if any.
fn judge(simulation: &dyn AnySimulation, motion: &Motion) -> Option<(Outcome, String)> {
    let time = simulation.time();
    let balance = simulation.energy().error / motion.energy;
    let violation = simulation.report().holonomic_error / motion.size;
    if !(balance <= ENERGY) {
        return Some((
            Outcome::EnergyGrowth,
            format!("{balance:.1e} of the kinetic energy gained at t = {time} s"),
        ));
    }
    if !(violation <= DRIFT) {
        return Some((
            Outcome::Drift,
            format!("rows violated by {violation:.1e} of the size at t = {time} s"),
        ));
    }
    let distance = motion.distance(simulation) / motion.size;
    if !(distance <= ASTRAY) {
        return Some((
            Outcome::WrongBranch,
            format!("{distance:.1e} of the size off the motion at t = {time} s"),
        ));
    }
    if balance < -ENERGY {
        return Some((
            Outcome::Drift,
            format!(
                "{:.1e} of the kinetic energy lost at t = {time} s",
                -balance
            ),
        ));
    }
    None
}
