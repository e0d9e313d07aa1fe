//! Processor time against accuracy, for every method over its steps or tolerances.

use std::io;

use super::measure::{errors, time};
use super::methods::{Control, Entry, entries};
use super::outcome::Outcome;
use super::store::{Row, Store};
use super::yardstick::{INSTANTS, Yardstick};

/// The columns of `work-precision.csv`; the first four identify a point.
pub const COLUMNS: [&str; 12] = [
    "scene",
    "method",
    "control",
    "value",
    "repeats",
    "outcome",
    "cpu_s",
    "steps",
    "position_error",
    "energy_error_J",
    "reaction_error",
    "detail",
];
/// How many of them identify a point.
pub const KEYS: usize = 4;

/// After this number of consecutive runs that were stopped, finer runs are not tried.
const ENOUGH: u32 = 3;

/// The limits of the work for a chart.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// A run is stopped after this processor time, s.
    pub patience: f64,
    /// Times are the least of this number of interleaved repeats.
    pub repeats: u32,
    /// Number of times that steps are halved (tolerances divided by ten).
    pub levels: u32,
    /// Only every n-th level is taken.
    pub stride: u32,
}

impl Effort {
    /// For a quick view, and for tests.
    pub const QUICK: Effort = Effort {
        patience: 0.1,
        repeats: 2,
        levels: 8,
        stride: 3,
    };
    /// For results.
    pub const FULL: Effort = Effort {
        patience: 0.4,
        repeats: 5,
        levels: 13,
        stride: 1,
    };

    fn levels(&self) -> impl Iterator<Item = u32> {
        (0..self.levels).step_by(self.stride as usize)
    }

    /// Points of a scene at most, repeats counted.
    pub fn points(&self) -> u64 {
        entries().len() as u64 * self.levels().count() as u64 * u64::from(self.repeats)
    }
}

/// A point that was read back.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Label of the method.
    pub method: String,
    /// Step, s, or tolerance.
    pub value: f64,
    /// The outcome of the run.
    pub outcome: Outcome,
    /// s
    pub cpu: f64,
    /// Errors of position, energy (J) and reaction.
    pub errors: [f64; 3],
}

impl Point {
    /// From a row of the file; `None` if the row has another form.
    pub fn read(row: &Row) -> Option<Self> {
        let number = |i: usize| row.get(i)?.parse::<f64>().ok();
        Some(Point {
            method: row.get(1)?.clone(),
            value: number(3)?,
            outcome: Outcome::by_name(row.get(5)?)?,
            cpu: number(6)?,
            errors: [number(8)?, number(9)?, number(10)?],
        })
    }
}

/// Step, tolerance or accuracy of a level.
fn control(entry: &Entry, duration: f64, level: u32) -> f64 {
    match entry.control {
        Control::Step => duration / f64::from(INSTANTS) / f64::from(1 << level),
        Control::Tolerance | Control::Accuracy => 10_f64.powi(-2 - level as i32),
    }
}

/// Measures the points of a scene that the store does not have yet. Methods and repeats alternate, from coarse to fine,
/// so that a slow period of the machine affects all methods.
///
/// # Errors
/// A file that cannot be written.
pub fn measure(
    yardstick: &Yardstick,
    effort: &Effort,
    store: &mut Store,
    tick: &mut dyn FnMut(),
) -> io::Result<()> {
    let entries = entries();
    let scene = yardstick.scene.name;
    // Consecutive runs that were stopped; with long steps each of them may take many iterations.
    let mut given_up: Vec<u32> = vec![0; entries.len()];
    for level in effort.levels() {
        for (entry, given_up) in entries.iter().zip(&mut given_up) {
            tick();
            if *given_up >= ENOUGH {
                continue;
            }
            let value = control(entry, yardstick.duration, level);
            let key = [
                scene,
                entry.label,
                entry.control.name(),
                &format!("{value:e}"),
            ];
            if store.find(&key).is_none() {
                store.put(first(yardstick, entry, value, effort, &key))?;
            }
            let point = store.find(&key).and_then(Point::read);
            let slower = f64::from(1 << effort.stride);
            *given_up = match point {
                Some(point) if point.outcome == Outcome::TooSlow => *given_up + 1,
                Some(point) if point.outcome == Outcome::Refused => ENOUGH,
                Some(point) if point.cpu * slower < effort.patience => 0,
                _ => ENOUGH,
            };
        }
    }
    for repeat in 1..effort.repeats {
        for level in effort.levels() {
            for entry in &entries {
                tick();
                let value = control(entry, yardstick.duration, level);
                let text = format!("{value:e}");
                let key = [scene, entry.label, entry.control.name(), &text];
                let Some(row) = store.find(&key).cloned() else {
                    continue;
                };
                if row[5] == Outcome::Ok.name() && row[4] == repeat.to_string() {
                    store.put(again(yardstick, entry, value, row))?;
                }
            }
        }
    }
    store.compact()
}

/// Errors and a first time.
fn first(
    yardstick: &Yardstick,
    entry: &Entry,
    value: f64,
    effort: &Effort,
    key: &[&str; KEYS],
) -> Row {
    let found = errors(yardstick, entry, value, effort.patience);
    let cpu = match found.outcome {
        Outcome::Ok => time(yardstick, entry, value).unwrap_or(f64::NAN),
        _ => found.cpu,
    };
    let numbers = [cpu, found.steps as f64, found.position, found.energy];
    let mut row: Row = key.iter().map(|&cell| cell.to_owned()).collect();
    row.push("1".to_owned());
    row.push(found.outcome.name().to_owned());
    row.extend(numbers.iter().map(|number| format!("{number:.6e}")));
    row.push(format!("{:.6e}", found.reaction));
    row.push(found.detail);
    row
}

/// Another measured time; the least one counts.
fn again(yardstick: &Yardstick, entry: &Entry, value: f64, mut row: Row) -> Row {
    let before: f64 = row[6].parse().unwrap_or(f64::INFINITY);
    let now = time(yardstick, entry, value).unwrap_or(f64::INFINITY);
    let repeats: u32 = row[4].parse().unwrap_or(0);
    row[4] = (repeats + 1).to_string();
    row[6] = format!("{:.6e}", before.min(now));
    row
}
