//! Runs the cells of a map and finds their outcomes, by the criteria of [`super::super::outcome`].

use std::collections::HashMap;
use std::io;

use cpu_time::ProcessTime;
use mbs_runtime::{AnySimulation, SimulationError};

use super::super::methods::entry;
use super::super::outcome::{ASTRAY, DRIFT, ENERGY, Outcome};
use super::super::store::{Row, Store};
use super::{Map, Problem, Trial};

/// Number of instants at which a run is tested.
const LOOKS: u32 = 200;
/// Instants of the right motion.
const POSES: u32 = 2000;
/// Its duration, s: in this time every mechanism here returns to its first poses.
const FOLLOWED: f64 = 10.0;
/// The step, of order 8, as a fraction of that time,
const FINE: f64 = 1.0 / 8000.0;
/// how often it is divided by four at most, and the difference of two runs, relative to the size, at which this ends.
const REFINEMENTS: i32 = 3;
const AGREED: f64 = 1e-2;

/// Named points of a pose.
type Pose = Vec<[f64; 3]>;

/// The right motion, as far as fine runs determine it.
struct Motion {
    /// Empty if the poses do not form a curve.
    poses: Vec<Pose>,
    /// The largest extent of the mechanism's points, m.
    size: f64,
    /// The largest kinetic energy, J.
    energy: f64,
}

impl Motion {
    /// From runs with finer and finer steps, until two agree.
    fn new(problem: &Problem) -> Result<Self, String> {
        let mut motion = Self::follow(problem, FINE)?;
        if !problem.one_degree_of_freedom {
            motion.poses.clear();
            return Ok(motion);
        }
        for finer in 1..=REFINEMENTS {
            let better = Self::follow(problem, FINE / 4_f64.powi(finer))?;
            let pairs = motion.poses.iter().zip(&better.poses);
            let apart = pairs.fold(0.0, |most: f64, (a, b)| most.max(apart(a, b)));
            motion = better;
            if apart <= AGREED * motion.size {
                return Ok(motion);
            }
        }
        Err("fine runs do not agree about it".to_owned())
    }

    fn follow(problem: &Problem, part: f64) -> Result<Self, String> {
        let entry = entry("two-level 8").ok_or("two-level is no method")?;
        let followed = problem.duration.min(FOLLOWED);
        let settings = entry.settings(followed, followed * part);
        let words = |error: SimulationError| error.to_string();
        let mut simulation = problem.build(settings).map_err(words)?;
        let mut motion = Motion {
            poses: vec![simulation.points()],
            size: 0.0,
            energy: simulation.energy().kinetic,
        };
        for i in 1..=POSES {
            let until = followed * f64::from(i) / f64::from(POSES);
            simulation.run_until(until).map_err(words)?;
            motion.poses.push(simulation.points());
            motion.energy = motion.energy.max(simulation.energy().kinetic);
        }
        motion.size = extent(&motion.poses);
        Ok(motion)
    }

    /// The distance of a pose from the nearest pose of the motion, m.
    fn distance(&self, pose: &Pose) -> f64 {
        let distances = self.poses.iter().map(|other| apart(pose, other));
        let nearest = distances.fold(f64::INFINITY, f64::min);
        if self.poses.is_empty() { 0.0 } else { nearest }
    }
}

/// The largest distance between the same points of two poses, m.
fn apart(a: &Pose, b: &Pose) -> f64 {
    let pairs = a.iter().zip(b);
    let square = pairs.map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum());
    square.fold(0.0, f64::max).sqrt()
}

/// The longest edge of the box around all points.
fn extent(poses: &[Pose]) -> f64 {
    let edge = |axis: usize| {
        let values = poses.iter().flatten().map(|point| point[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (x.min(low), x.max(high))
        });
        high - low
    };
    (0..3).map(edge).fold(1e-3, f64::max)
}

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
    let mut ends: Vec<(Outcome, String)> = Vec::new();
    for trial in &trials {
        let end = run(trial, patience, motions);
        let useless = matches!(end.0, Outcome::TooSlow | Outcome::Refused);
        ends.push(end);
        if useless {
            break;
        }
    }
    let failures: Vec<&(Outcome, String)> = ends.iter().filter(|e| e.0.is_failure()).collect();
    let count = |outcome: Outcome| failures.iter().filter(|e| e.0 == outcome).count();
    let frequent = failures.iter().map(|e| e.0).max_by_key(|&o| count(o));
    let last = ends.last().map_or(Outcome::Refused, |end| end.0);
    let first_words = match failures.first() {
        Some((_, words)) => words.clone(),
        None => ends.last().map_or(String::new(), |end| end.1.clone()),
    };
    let mut row: Row = key.iter().map(|&cell| cell.to_owned()).collect();
    row.extend([
        frequent.unwrap_or(last).name().to_owned(),
        ends.len().to_string(),
        failures.len().to_string(),
        format!("{:.3e}", start.elapsed().as_secs_f64()),
        first_words,
    ]);
    row
}

/// The outcome of one run, with a message if it failed.
fn run(trial: &Trial, patience: f64, motions: &mut HashMap<String, Motion>) -> (Outcome, String) {
    let failed = |error: SimulationError| (Outcome::of_error(&error), error.to_string());
    let problem = &trial.problem;
    let mut simulation = match problem.build(trial.settings) {
        Ok(simulation) => simulation,
        Err(error) => return failed(error),
    };
    let key = problem.key();
    if !motions.contains_key(&key) {
        match Motion::new(problem) {
            Ok(motion) => motions.insert(key.clone(), motion),
            Err(error) => return (Outcome::Refused, format!("no right motion: {error}")),
        };
    }
    let motion = &motions[&key];
    let start = ProcessTime::now();
    for look in 1..=LOOKS {
        let until = problem.duration * f64::from(look) / f64::from(LOOKS);
        if let Err(error) = simulation.run_until(until) {
            return failed(error);
        }
        if let Some(end) = judge(simulation.as_ref(), motion) {
            return end;
        }
        if start.elapsed().as_secs_f64() > patience {
            return (Outcome::TooSlow, format!("given up at t = {until} s"));
        }
    }
    (Outcome::Ok, String::new())
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
    let distance = motion.distance(&simulation.points()) / motion.size;
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
