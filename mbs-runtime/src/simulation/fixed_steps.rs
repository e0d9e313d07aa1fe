//! Steps of fixed length past poses that are nearly singular.
//!
//! Each step is the second of a pair with the step before it. A pose that σ foresees in it, or in one of the next steps,
//! is looked at once (`passage.rs`). Past one that is nearly singular the motion turns within a time of g/k, with the
//! least σ g and its rate k: steps of a part of σ/k take the place of longer ones until the pose is left behind.

use super::Simulation;
use super::known_poses::{ALIKE, SAME};
use super::passage::{LEAP, Pose};
use super::pose::{Foreseen, LastStep, NEAR_AHEAD, Passage};
use crate::{SimulationError, System};

/// Steps past such a pose, as a part of σ/k.
const PART: f64 = 0.25;
/// The shortest of them, as a part of the step.
const SHORTEST: f64 = 1e-5;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// A step with placement, or short ones if it leaps over a pose that is nearly singular.
    pub(super) fn follow(&mut self, h: f64, left: f64) -> Result<f64, SimulationError> {
        let mut step = LastStep {
            begin: self.time(),
            ..LastStep::NONE
        };
        if let Some(margin) = &self.rank_margin {
            (step.least, step.dependent) = (margin.least, margin.dependent);
        }
        if let Some(Foreseen::Turn(rate)) = self.foreseen {
            if self.resolving(rate) < h && self.turn_past(h, rate)? {
                return Ok(h);
            }
            self.foreseen = None;
        }
        let length = self.placed(h, left)?;
        let now = self.rank_margin.as_ref().map_or(f64::NAN, |now| now.least);
        if self.last_step.suspects(length, step.least, now) && self.corrects(&step, length)? {
            return Ok(length);
        }
        step.length = length;
        self.last_step = step;
        self.watch();
        Ok(length)
    }

    /// Replaces the last step by short ones if it leaps over a pose that is nearly singular; whether it does.
    #[cold]
    #[inline(never)]
    fn corrects(&mut self, step: &LastStep, length: f64) -> Result<bool, SimulationError> {
        // Pairs are looked at as a whole.
        if self.settings.tolerance.is_some() || !self.is_free() {
            return Ok(false);
        }
        let last = self.last_step;
        // The end of a run removes the rounding of its sum of steps from the clock.
        let apart = (step.begin - last.begin - last.length).abs();
        let follows = apart <= 1e-6 * length && last.length > 0.0;
        let passage = Passage {
            steps: [last.length, length],
            margins: [last.margin(), step.margin(), self.margin()],
        };
        if !follows || !self.leapt(&passage)? {
            return Ok(false);
        }
        let Some(Foreseen::Turn(rate)) = self.foreseen else {
            return Ok(false);
        };
        self.back()?;
        self.rejected += 1;
        if !self.turn_past(length, rate)? {
            self.foreseen = None;
            self.advance(length)?;
            self.watch();
        }
        Ok(true)
    }

    /// Looks at the pose in the last step, the second of the pair, or after it. Whether the step, of which `self.before`
    /// is the beginning, is too long for a pose that is nearly singular.
    #[inline]
    fn leapt(&mut self, passage: &Passage) -> Result<bool, SimulationError> {
        for pose in passage.poses_from_second().into_iter().flatten() {
            if let Some(too_long) = self.look_about(passage, pose)? {
                return Ok(too_long);
            }
        }
        Ok(false)
    }

    /// The same for one of the poses; `None` if it is not found.
    #[cold]
    #[inline(never)]
    fn look_about(
        &mut self,
        passage: &Passage,
        pose: f64,
    ) -> Result<Option<bool>, SimulationError> {
        let [first, second] = passage.steps;
        let length = first + second;
        let time = self.time() - length + pose;
        if let Some(Foreseen::Singular(known)) = self.foreseen
            && (time - known).abs() < second
        {
            return Ok(Some(false));
        }
        let behind = pose < length;
        // Beyond the end of the step the cubic is not exact: the pose is looked at from the next one, if it is no other.
        let within = if behind { SAME } else { ALIKE };
        if self.is_known(&self.before, (pose - first) / second, within) {
            return Ok(Some(false));
        }
        let kept = self.keep();
        if behind {
            std::mem::swap(&mut self.pair, &mut self.before);
            self.before.copy_from(self.integrator.state());
        } else {
            self.pair.copy_from(self.integrator.state());
        }
        let window = match behind {
            true => [first, length],
            false => [length, length + 2.0 * NEAR_AHEAD * second],
        };
        let found = self.find(passage, pose, window);
        let end = if behind { &self.before } else { &self.pair };
        self.integrator.state_mut().copy_from(end);
        if behind {
            std::mem::swap(&mut self.pair, &mut self.before);
        }
        self.restore(kept)?;
        let [_, _, end] = passage.margins;
        Ok(match found? {
            Pose::Turn { least, rate } if PART * least < rate * second => {
                self.foreseen = Some(Foreseen::Turn(rate));
                Some(behind || end.least < LEAP * least)
            }
            Pose::Singular => {
                self.foreseen = Some(Foreseen::Singular(time));
                Some(false)
            }
            Pose::Turn { .. } => Some(false),
            Pose::Unclear => None,
        })
    }

    /// Steps over `span` seconds, each a part of the time in which σ would fall to zero at this rate. Where one of them
    /// fails, or comes to a singular pose, none is taken, and the answer is false.
    #[cold]
    #[inline(never)]
    fn turn_past(&mut self, span: f64, rate: f64) -> Result<bool, SimulationError> {
        self.last_step = LastStep::NONE;
        self.before.copy_motion_from(self.integrator.state());
        self.started = self.books;
        let mut left = span;
        while left > 0.0 {
            let h = self.resolving(rate).max(SHORTEST * span);
            let last = h > 0.7 * left;
            let taken = self.advance(if last { left } else { h });
            let singular = taken.is_ok() && self.margin().least <= self.least_distinct();
            match taken {
                Ok(_) if !singular => self.watch(),
                Err(error) if !error.asks_for_less() => return Err(error),
                _ => {
                    self.back()?;
                    return Ok(false);
                }
            }
            left = if last { 0.0 } else { left - h };
        }
        Ok(true)
    }

    /// The step that resolves the motion where σ changes at this rate, s.
    fn resolving(&mut self, rate: f64) -> f64 {
        PART * self.margin().least / rate
    }
}
