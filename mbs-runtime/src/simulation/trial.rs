//! What a method needs for a motion: it runs ahead, and its operations are counted.

use super::Simulation;
use super::choice::Character;
use super::pose::FAR;
use crate::work::Work;
use crate::{Method, SimulationError, System};

/// Pairs of steps that are counted, after the first length of steps was found.
const COUNTED: f64 = 12.0;
/// How often they are counted anew while steps grow, and by which factor at least they do so in the time of a count where their
/// length follows the motion.
const WINDOWS: usize = 6;
const GROWN: f64 = 2.0;
/// Pairs that a candidate has for finding it.
const TRIED: usize = 60;

/// The work of another method, as a part of that of the method in use, with which it is taken: a change costs a few steps
/// until the new lengths are found.
pub(super) const GAIN: f64 = 0.7;
/// A candidate is given up once its trial has taken more operations than the whole trial of the leader, if it takes over this
/// many times as many for a second: its steps become four times as long at most where they grow once more. It is given up, too, once
/// it has taken this many times the operations of that trial and has not come as far.
const HOPELESS: f64 = 4.0;
/// Pairs of explicit steps that go a shorter way, in sizes and radians, are short for another reason than the motion: a stiff
/// damper, or a tolerance near round-off. Then steps of the other candidate may grow a hundred times longer.
const MOVING: f64 = 0.01;

/// What a candidate needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trial {
    /// Operations for a second of the motion; infinite if it cannot go on, or was given up.
    pub(super) rate: f64,
    /// The times between which they were counted, s.
    pub(super) span: [f64; 2],
    /// All operations of the trial.
    pub(super) operations: f64,
    /// The length of its steps at the end of the trial, s, …
    pub(super) step: f64,
    /// … and the factor of the estimates of its errors.
    pub(super) estimate_factor: f64,
    /// The mean way of the pairs that were counted, in sizes and radians.
    pub(super) way: f64,
    /// Whether stiff dampers do not shorten its steps.
    damps: bool,
}

impl Trial {
    /// Of a candidate that cannot go on.
    pub(super) const NONE: Trial = Trial {
        rate: f64::INFINITY,
        span: [f64::INFINITY; 2],
        operations: f64::INFINITY,
        step: 0.0,
        estimate_factor: 0.0,
        way: 0.0,
        damps: false,
    };

    /// Whether the candidate could go on.
    pub(super) fn has_run(&self) -> bool {
        self.operations.is_finite()
    }

    /// Whether it was given up because another one needs far less.
    pub(super) fn is_hopeless(&self) -> bool {
        self.has_run() && !self.rate.is_finite()
    }

    /// Of a candidate that was given up after so many operations.
    fn hopeless(operations: f64) -> Self {
        Trial {
            operations,
            ..Trial::NONE
        }
    }

    /// What the motion was like.
    pub(super) fn character(&self) -> Character {
        Character {
            way: self.way,
            rate: self.rate,
        }
    }

    /// Whether the lengths of its steps are those that the motion needs.
    pub(super) fn follows_the_motion(&self) -> bool {
        self.rate.is_finite() && (self.damps || self.way > MOVING)
    }

    /// Operations for a second from `begin` on, where the trial began.
    pub(super) fn mean_rate(&self, begin: f64) -> f64 {
        self.operations / (self.span[1] - begin)
    }

    /// Whether a candidate that has come to this time with so many operations, at this rate if it is known, need not be tried further.
    fn outdoes(&self, operations: f64, time: f64, rate: Option<f64>) -> bool {
        let is_faster =
            operations > self.operations && rate.is_some_and(|rate| rate > HOPELESS * self.rate);
        let is_ahead = operations > HOPELESS * self.operations && time < self.span[1];
        self.follows_the_motion() && (is_faster || is_ahead)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// What the method needs from this state on: it runs until the length of the steps is found, and then counts. It ends with
    /// what was found up to then after so many operations, with [`Trial::NONE`] where it cannot go on, and without a finite rate
    /// where it is hopeless beside the other one.
    pub(super) fn run_trial(&mut self, most: f64, other: &Trial) -> Trial {
        self.tried(most, other).unwrap_or(Trial::NONE)
    }

    fn tried(&mut self, most: f64, other: &Trial) -> Result<Trial, SimulationError> {
        let (work, begin, start) = (self.work(), self.report(), self.time());
        if self.damps() && !(self.margin().least > FAR) {
            return Ok(Trial::NONE);
        }
        for _ in 0..TRIED {
            if self.state().step_controller.step > 0.0 && !self.state().step_controller.searching {
                break;
            }
            self.forward(self.nominal(), f64::INFINITY)?;
            let operations = work.between(&begin, &self.report());
            if other.outdoes(operations, self.time(), None) {
                return Ok(Trial::hopeless(operations));
            }
            if operations > most {
                let rate = operations / (self.time() - start);
                return Ok(self.trial(rate, [start, self.time()], operations, self.way()));
            }
        }
        // A transient at the start needs short steps: the count begins anew while they grow, and until the other candidate has
        // been counted, too, where this takes less than that trial.
        let grown = if self.follows() { GROWN } else { 1.0 };
        let mut trial = Trial::NONE;
        for window in 1.. {
            let step = self.nominal();
            let before = work.between(&begin, &self.report());
            trial = self.count(&work, before, most, other)?;
            if trial.operations > most {
                break;
            }
            let is_behind = self.time() < other.span[1] && trial.operations < other.operations;
            // A hopeless trial has no length.
            let goes_on = trial.step > grown * step && window < WINDOWS
                || other.rate.is_finite() && trial.rate.is_finite() && is_behind;
            if !goes_on {
                break;
            }
        }
        Ok(trial)
    }

    /// What the method needs from this state on in the span of another trial, whose rate is finite. It ends earlier where it
    /// takes more operations than that trial as a whole, by 1/[`GAIN`].
    pub(super) fn run_beside(&mut self, other: &Trial) -> Trial {
        let (begin, start, work) = (self.time(), self.report(), self.work());
        let (mut before, mut way, mut pairs) = ((begin, 0.0), 0.0, 0.0);
        let [from, to] = other.span;
        loop {
            if self.forward(self.nominal(), f64::INFINITY).is_err() {
                return Trial {
                    way: other.way,
                    ..Trial::NONE
                };
            }
            let (time, operations) = (self.time(), work.between(&start, &self.report()));
            (way, pairs) = (way + self.way(), pairs + 1.0);
            let trial = |rate| self.trial(rate, [begin, time], operations, way / pairs);
            if time >= to {
                return trial((operations - before.1) / (time - before.0));
            }
            if operations > other.operations / GAIN {
                // It is behind over the whole time, which may have hard and easy parts.
                let times = operations / (time - begin) / other.mean_rate(begin);
                return trial(other.rate * times.max(1.0 / GAIN));
            }
            if time <= from {
                before = (time, operations);
            }
        }
    }

    /// The operations of some pairs, after those `before` them.
    fn count(
        &mut self,
        work: &Work,
        before: f64,
        most: f64,
        other: &Trial,
    ) -> Result<Trial, SimulationError> {
        let (start, begin) = (self.time(), self.report());
        let (mut way, mut operations, mut pairs) = (0.0, 0.0, 0.0);
        while pairs < COUNTED && before + operations <= most {
            self.forward(self.nominal(), f64::INFINITY)?;
            (way, pairs) = (way + self.way(), pairs + 1.0);
            operations = work.between(&begin, &self.report());
            let rate = operations / (self.time() - start);
            let all = before + operations;
            if other.outdoes(all, self.time(), Some(rate)) {
                return Ok(Trial::hopeless(all));
            }
        }
        let (span, all) = ([start, self.time()], before + operations);
        Ok(self.trial(operations / (span[1] - start), span, all, way / pairs))
    }

    /// What was found up to now: operations for a second, the span in which they were counted, all of them, and the way of pairs.
    fn trial(&self, rate: f64, span: [f64; 2], operations: f64, way: f64) -> Trial {
        Trial {
            rate,
            span,
            operations,
            step: self.nominal(),
            estimate_factor: self.estimate_factor(),
            way,
            damps: self.damps(),
        }
    }

    /// The factor of the estimates by which lengths follow the motion; otherwise zero.
    fn estimate_factor(&self) -> f64 {
        match self.follows() {
            true => self.state().step_controller.estimate_factor,
            false => 0.0,
        }
    }

    /// Whether the method is Radau, which is a candidate far from singular poses.
    fn damps(&self) -> bool {
        self.settings.method == Method::Radau
    }

    /// The operations of stages and corrections with the method in use.
    pub(super) fn work(&self) -> Work {
        let plan = S::ELIMINATION.filter(|_| self.integrator.is_sparse());
        let planned = plan.map(|plan| plan.operations);
        Work::of(S::MODEL, &self.settings, self.flow(), planned)
    }
}
