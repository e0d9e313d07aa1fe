//! The method that was chosen for an accuracy, and when the choice is made again (`revision.rs`).

use crate::work::Work;
use crate::{MethodChange, Report, Settings};

/// A pair whose way is this many times longer or shorter than at the choice is unlike those at the choice.
const UNLIKE: f64 = 8.0;
/// Pairs in a row that go such ways.
const IN_A_ROW: u32 = 16;
/// The operations before the next trials, as a multiple of those of the last ones; this grows by the second factor where they
/// have changed nothing.
const WAIT: f64 = 4.0;
const LONGER: f64 = 2.0;
/// After as many times these operations trials are made in any case.
const ANYWAY: f64 = 16.0;
/// The part of the operations since the last trials that others may take, where ways are unlike and in any case.
const PARTS: [f64; 2] = [0.25, 0.0625];
/// Pairs between looks at this number of operations.
const SELDOM: u64 = 256;

/// The method that was chosen, and what is known about it.
#[derive(Debug, Clone)]
pub(super) struct Choice {
    candidates: Vec<Settings>,
    current: usize,
    /// What a stage of the method in use takes.
    pub(super) work: Work,
    /// The way of a pair at the choice, in sizes and radians.
    way: f64,
    /// Pairs in a row whose ways are not like this one.
    unlike: u32,
    /// Pairs since the choice.
    pairs: u64,
    /// Time and report at the choice, and the operations since then after which it may be made again.
    start: (f64, Report),
    wait: f64,
    changes: Vec<MethodChange>,
}

impl Choice {
    /// After trials with so many operations: that of the method that was chosen had pairs of this way.
    pub(super) fn new(
        candidates: Vec<Settings>,
        current: usize,
        work: Work,
        way: f64,
        start: f64,
        operations: f64,
    ) -> Self {
        Choice {
            candidates,
            current,
            work,
            way,
            unlike: 0,
            pairs: 0,
            start: (start, Report::default()),
            wait: operations,
            changes: Vec::new(),
        }
    }

    /// Takes note of a pair that goes this way; whether it is time to look at the operations since the choice.
    pub(super) fn note(&mut self, way: f64) -> bool {
        let is_like = way * UNLIKE > self.way && way < UNLIKE * self.way;
        self.unlike = if is_like { 0 } else { self.unlike + 1 };
        self.pairs += 1;
        self.unlike >= IN_A_ROW || self.pairs.is_multiple_of(SELDOM)
    }

    /// The operations that trials may take now, after so many since the choice; `None`: they may not be made yet.
    pub(super) fn allowed(&self, done: f64) -> Option<f64> {
        match self.unlike >= IN_A_ROW {
            true => (done >= self.wait).then_some(PARTS[0] * done),
            false => (done >= ANYWAY * self.wait).then_some(PARTS[1] * done),
        }
    }

    /// After trials with so many operations, in which pairs went this way: the method stays. If the trials say nothing about the
    /// rest of the motion, the next ones are not made later than these.
    pub(super) fn stay(&mut self, now: (f64, Report), spent: f64, way: f64, conclusive: bool) {
        let longer = if conclusive { LONGER } else { 1.0 };
        self.rest(now, (WAIT * spent).max(longer * self.wait), way);
    }

    /// After the same, or where the method cannot go on: another candidate is taken.
    pub(super) fn change(
        &mut self,
        candidate: usize,
        now: (f64, Report),
        spent: f64,
        way: f64,
        change: MethodChange,
    ) {
        self.current = candidate;
        self.changes.push(change);
        match spent.is_finite() {
            true => self.rest(now, WAIT * spent, way),
            false => self.rest(now, self.wait, self.way),
        }
    }

    /// A candidate that is not in use is none any more.
    pub(super) fn leave_out(&mut self, candidate: usize) {
        self.candidates.remove(candidate);
        self.current -= usize::from(candidate < self.current);
    }

    /// The candidate in use.
    pub(super) fn current(&self) -> usize {
        self.current
    }

    fn rest(&mut self, now: (f64, Report), wait: f64, way: f64) {
        (self.start, self.wait, self.way) = (now, wait, way);
        (self.unlike, self.pairs) = (0, 0);
    }

    /// The candidates that are not in use.
    pub(super) fn others(&self) -> impl DoubleEndedIterator<Item = usize> + use<> {
        let current = self.current;
        (0..self.candidates.len()).filter(move |&candidate| candidate != current)
    }

    /// The settings of a candidate.
    pub(super) fn settings_of(&self, candidate: usize) -> Settings {
        self.candidates[candidate]
    }

    /// Time and report at the choice.
    pub(super) fn start(&self) -> &(f64, Report) {
        &self.start
    }

    /// The way of a pair at the choice.
    pub(super) fn way(&self) -> f64 {
        self.way
    }

    /// The changes of the method so far.
    pub(super) fn changes(&self) -> &[MethodChange] {
        &self.changes
    }
}
