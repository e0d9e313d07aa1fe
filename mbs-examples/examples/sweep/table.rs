//! The outcomes of a sweep, by mechanism and method.

use crate::trial::{End, Trial};
use std::collections::BTreeMap;
use std::fmt;

/// Columns of the file; the first two identify a row.
pub const COLUMNS: [&str; 9] = [
    "scene",
    "method",
    "runs",
    "ok",
    "stopped",
    "errors",
    "lost",
    "lost_unplaced",
    "panics",
];

/// The outcomes of the runs of a mechanism with a method.
#[derive(Default)]
pub struct Count {
    runs: usize,
    ok: usize,
    stopped: BTreeMap<String, usize>,
    /// Runs that are lost without a word.
    pub lost: usize,
    /// The same without placement.
    lost_unplaced: usize,
    /// Runs that panicked.
    pub panics: usize,
}

impl Count {
    /// Counts a run.
    pub fn add(&mut self, trial: &Trial, end: &End, lost: bool) {
        self.runs += 1;
        match end {
            End::Ok { .. } => self.ok += 1,
            End::Stopped(name) => *self.stopped.entry(name.clone()).or_default() += 1,
            End::Panic(_) => self.panics += 1,
        }
        match trial.placement {
            true => self.lost += usize::from(lost),
            false => self.lost_unplaced += usize::from(lost),
        }
    }

    /// Adds the counts of another.
    pub fn join(&mut self, other: &Count) {
        self.runs += other.runs;
        self.ok += other.ok;
        for (name, count) in &other.stopped {
            *self.stopped.entry(name.clone()).or_default() += count;
        }
        self.lost += other.lost;
        self.lost_unplaced += other.lost_unplaced;
        self.panics += other.panics;
    }

    /// The cells of a row after the first two.
    pub fn cells(&self) -> Vec<String> {
        let errors = self
            .stopped
            .iter()
            .map(|(name, count)| format!("{name} {count}"));
        vec![
            self.runs.to_string(),
            self.ok.to_string(),
            self.stopped.values().sum::<usize>().to_string(),
            errors.collect::<Vec<_>>().join("; "),
            self.lost.to_string(),
            self.lost_unplaced.to_string(),
            self.panics.to_string(),
        ]
    }
}

impl fmt::Display for Count {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cells = self.cells();
        write!(
            out,
            "{:>6} runs {:>6} ok {:>5} stopped {:>4} lost {:>4} unplaced {:>3} panics  {}",
            cells[0], cells[1], cells[2], cells[4], cells[5], cells[6], cells[3]
        )
    }
}
