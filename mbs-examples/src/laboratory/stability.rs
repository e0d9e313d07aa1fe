//! Outcome maps: the outcome of runs for a method and a step (or a penalty, a stiffness, a ratio of masses).

mod difficulties;
mod maps;
mod motion;
mod run;

pub use maps::maps;
pub use run::measure;

use mbs_runtime::{AnySimulation, Settings, SimulationError};

use super::outcome::Outcome;
use super::store::Row;
use crate::scene::Scene;

/// The columns of `stability.csv`; the first three identify a cell.
pub const COLUMNS: [&str; 9] = [
    "map", "row", "column", "outcome", "runs", "failed", "stopped", "cpu_s", "detail",
];
/// How many of them identify a cell.
pub const KEYS: usize = 3;

/// A mechanism with its parameters, for a time.
#[derive(Debug, Clone)]
pub struct Problem {
    /// The mechanism.
    pub scene: &'static Scene,
    /// By name.
    pub parameters: Vec<(String, f64)>,
    /// s
    pub duration: f64,
    /// What tells that a run is on the right branch.
    pub branch: Branch,
    /// An input that takes another value at each instant at which the run is tested, and its largest value.
    pub jumps: Option<(&'static str, f64)>,
    /// A parameter that has this value in the runs for size and kinetic energy.
    pub measured_with: Option<(&'static str, f64)>,
}

/// What tells that a run is on the right branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// With one degree of freedom the poses of the right motion form a curve: each pose is near one of them.
    Curve,
    /// Each pose is near that of the right motion at the same instant.
    Motion,
    /// This output is zero, m.
    Output(&'static str),
    /// Nothing.
    Unknown,
}

/// Where a run is interrupted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Course {
    /// Nowhere: it is tested at the first end of a step after each instant.
    Whole,
    /// At the instants at which it is tested.
    Instants,
    /// There, and every so many seconds.
    Pieces(f64),
}

impl Problem {
    /// A mechanism of one degree of freedom with its default parameters.
    pub fn new(scene: &'static Scene, duration: f64) -> Self {
        Problem {
            scene,
            parameters: Vec::new(),
            duration,
            branch: Branch::Curve,
            jumps: None,
            measured_with: None,
        }
    }

    /// With a parameter.
    pub fn with(mut self, name: &str, value: f64) -> Self {
        self.parameters.push((name.to_owned(), value));
        self
    }

    /// The simulation at its start.
    ///
    /// # Errors
    /// As the scene's.
    pub fn build(&self, settings: Settings) -> Result<Box<dyn AnySimulation>, SimulationError> {
        (self.scene.build)(&self.parameters, settings)
    }

    /// Problems of the same key have the same right motion.
    fn key(&self) -> String {
        format!("{} {:?}", self.scene.name, self.parameters)
    }
}

/// One run of a cell.
pub struct Trial {
    /// The problem.
    pub problem: Problem,
    /// The settings.
    pub settings: Settings,
    /// Where it is interrupted.
    pub course: Course,
}

/// A map.
pub struct Map {
    /// In file names.
    pub name: &'static str,
    /// For people.
    pub title: &'static str,
    /// The quantity of the columns.
    pub axis: &'static str,
    /// Labels of the rows.
    pub rows: Vec<String>,
    /// Values of the columns.
    pub columns: Vec<f64>,
    /// The runs of a cell, by indices of row and column.
    pub trials: Box<dyn Fn(usize, usize) -> Vec<Trial>>,
}

/// A cell that was read back.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// Label of its row.
    pub row: String,
    /// Value of its column.
    pub column: f64,
    /// The most frequent outcome among runs that failed, or of all.
    pub outcome: Outcome,
    /// Runs, how many of them failed, and how many of these stopped with an error of their own.
    pub runs: [usize; 3],
    /// Of the first failure.
    pub detail: String,
}

impl Cell {
    /// From a row of the file; `None` if it is no such row.
    pub fn read(row: &Row) -> Option<Self> {
        let count = |i: usize| row.get(i)?.parse().ok();
        Some(Cell {
            row: row.get(1)?.clone(),
            column: row.get(2)?.parse().ok()?,
            outcome: Outcome::by_name(row.get(3)?)?,
            runs: [count(4)?, count(5)?, count(6)?],
            detail: row.get(8)?.clone(),
        })
    }

    /// Whether runs failed, and every one of them stopped with an error of its own: none went on with a wrong motion.
    pub fn is_stopped(&self) -> bool {
        let [_, failed, stopped] = self.runs;
        failed > 0 && stopped == failed
    }
}
