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
/// The part of the operations since the last trials that others may take, where the motion has changed and in any case.
const PARTS: [f64; 2] = [0.25, 0.0625];
/// The motion has changed, too, if a second of it takes this many times the operations of the trial.
const DEARER: f64 = 2.0;
/// Pairs between looks at this number of operations.
const SELDOM: u64 = 256;

/// The method that was chosen, and what is known about it.
#[derive(Debug, Clone)]
pub(super) struct Choice {
    candidates: Vec<Candidate>,
    current: usize,
    /// What a stage of the method in use takes.
    pub(super) work: Work,
    /// What the motion was like at the choice.
    character: Character,
    /// Pairs in a row whose ways are not like this one.
    unlike: u32,
    /// Pairs since the choice.
    pairs: u64,
    /// Time and report at the choice, and the operations since then after which it may be made again.
    start: (f64, Report),
    wait: f64,
    changes: Vec<MethodChange>,
}

/// A method that may be chosen.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    pub(super) settings: Settings,
    /// Whether its trial at the beginning was given up.
    pub(super) is_hopeless: bool,
}

/// What a motion is like, as a trial shows it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Character {
    /// The way of a pair, in sizes and radians.
    pub(super) way: f64,
    /// Operations for a second.
    pub(super) rate: f64,
}

impl Choice {
    /// After trials with so many operations at least; infinite: there were none.
    pub(super) fn new(
        candidates: Vec<Candidate>,
        current: usize,
        work: Work,
        start: f64,
        (operations, character): (f64, Character),
    ) -> Self {
        Choice {
            wait: match operations.is_finite() {
                true => candidates.len() as f64 * operations,
                false => 0.0,
            },
            candidates,
            current,
            work,
            character,
            unlike: 0,
            pairs: 0,
            start: (start, Report::default()),
            changes: Vec::new(),
        }
    }

    /// Takes note of a pair that goes this way; whether it is time to look at the operations since the choice.
    pub(super) fn note(&mut self, way: f64) -> bool {
        let is_like = way * UNLIKE > self.character.way && way < UNLIKE * self.character.way;
        self.unlike = if is_like { 0 } else { self.unlike + 1 };
        self.pairs += 1;
        // A few pairs may have taken more operations than a trial.
        let is_look = self.unlike.is_power_of_two() || self.pairs.is_multiple_of(SELDOM);
        self.unlike >= IN_A_ROW || is_look
    }

    /// The operations that trials may take at this time, after so many since the choice; `None`: they may not be made yet.
    pub(super) fn allowed(&self, done: f64, now: f64) -> Option<f64> {
        let is_dear = done > DEARER * self.character.rate * (now - self.start.0);
        match self.unlike >= IN_A_ROW || is_dear {
            true => (done >= self.wait).then_some(PARTS[0] * done),
            false => (done >= ANYWAY * self.wait).then_some(PARTS[1] * done),
        }
    }

    /// After trials with so many operations, in which the motion had this character: the method stays. If the trials say nothing about the
    /// rest of the motion, the next ones are not made later than these.
    pub(super) fn stay(
        &mut self,
        now: (f64, Report),
        spent: f64,
        character: Character,
        conclusive: bool,
    ) {
        let longer = if conclusive { LONGER } else { 1.0 };
        self.rest(now, (WAIT * spent).max(longer * self.wait), character);
    }

    /// After the same, or where the method cannot go on: another candidate is taken.
    pub(super) fn change(
        &mut self,
        candidate: usize,
        now: (f64, Report),
        (operations, character): (f64, Character),
        change: MethodChange,
    ) {
        self.current = candidate;
        self.changes.push(change);
        match operations.is_finite() {
            true => self.rest(now, WAIT * operations, character),
            false => self.rest(now, self.wait, self.character),
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

    fn rest(&mut self, now: (f64, Report), wait: f64, character: Character) {
        (self.start, self.wait, self.character) = (now, wait, character);
        (self.unlike, self.pairs) = (0, 0);
    }

    /// The candidates that are not in use, those that were hopeless at the beginning after the others.
    pub(super) fn others(&self) -> Vec<usize> {
        let others = (0..self.candidates.len()).filter(|&candidate| candidate != self.current);
        let mut others: Vec<_> = others.collect();
        others.sort_by_key(|&candidate| self.is_hopeless(candidate));
        others
    }

    /// Whether a candidate was hopeless at the beginning.
    pub(super) fn is_hopeless(&self, candidate: usize) -> bool {
        self.candidates[candidate].is_hopeless
    }

    /// The settings of a candidate.
    pub(super) fn settings_of(&self, candidate: usize) -> Settings {
        self.candidates[candidate].settings
    }

    /// Time and report at the choice.
    pub(super) fn start(&self) -> &(f64, Report) {
        &self.start
    }

    /// What the motion was like at the choice.
    pub(super) fn character(&self) -> Character {
        self.character
    }

    /// The changes of the method so far.
    pub(super) fn changes(&self) -> &[MethodChange] {
        &self.changes
    }
}
