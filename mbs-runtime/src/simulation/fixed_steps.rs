//! Steps of fixed length past poses that are nearly singular.
//!
//! Each step is the second of a pair with the step before it. A pose that σ foresees in it, or in one of the next steps,
//! is looked at once (`passage.rs`). Past one that is nearly singular the motion turns within a time of g/k, with the
//! least σ g and its rate k: steps of a part of σ/k take the place of longer ones until the pose is left behind.

use super::Simulation;
use super::known_poses::{ALIKE, SAME};
use super::passage::{LEAP, Pose};
use super::pose::{NEAR_AHEAD, Passage};
use crate::state::rounding;
use crate::{Foreseen, LastStep, SimulationError, System};

/// Steps past such a pose, as a part of σ/k.
const PART: f64 = 0.25;
/// The shortest of them, as a part of the step.
pub(super) const SHORTEST: f64 = 1e-5;
/// σ below this part of the least one that was foreseen is that of a singular pose.
const BELOW: f64 = 0.25;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// A step with placement, or short ones if it leaps over a pose that is nearly singular.
    pub(super) fn step_past_poses(&mut self, h: f64, left: f64) -> Result<f64, SimulationError> {
        // Pairs are looked at as a whole.
        if self.settings.tolerance.is_some() || !self.is_free() {
            let length = self.placed_step(h, left)?;
            self.watch();
            return Ok(length);
        }
        let (begin, last_step) = (self.time(), self.state().poses_ahead.last_step);
        // After an input has changed it is not known.
        self.rank_margin = self.rank_margin.or_else(|| self.integrator.rank_margin());
        let margin = self.rank_margin.map(|now| (now.least, now.dependent));
        if let Some(Foreseen::Turn { least, rate }) = self.foreseen() {
            if self.resolving(rate) < h && self.turn_past(h, least, rate)? {
                return Ok(h);
            }
            self.expect_pose(None);
        }
        let length = self.placed_step(h, left)?;
        let step = margin.map(|(least, dependent)| LastStep {
            begin,
            length,
            least,
            dependent,
        });
        if let (Some(last), Some(step), Some(now)) = (last_step, step, self.rank_margin)
            && last.suspects(length, step.least, now.least)
            && self.corrects(&last, &step)?
        {
            return Ok(length);
        }
        self.integrator.state_mut().poses_ahead.last_step = step;
        self.watch();
        Ok(length)
    }

    /// Replaces the last step by short ones if it leaps over a pose that is nearly singular; whether it does.
    #[cold]
    #[inline(never)]
    fn corrects(&mut self, last: &LastStep, step: &LastStep) -> Result<bool, SimulationError> {
        let length = step.length;
        // The end of a run removes the rounding of its sum of steps from the clock, and times are rounded.
        let apart = (step.begin - last.begin - last.length).abs();
        let follows = apart <= 1e-6 * length + rounding(step.begin) && last.length > 0.0;
        let passage = Passage {
            steps: [last.length, length],
            margins: [last.margin(), step.margin(), self.margin()],
            seen: None,
        };
        if !follows || !self.leapt(&passage)? {
            return Ok(false);
        }
        let Some(Foreseen::Turn { least, rate }) = self.foreseen() else {
            return Ok(false);
        };
        self.back()?;
        self.rejected += 1;
        if !self.turn_past(length, least, rate)? {
            self.expect_pose(None);
            self.advance(length)?;
            self.watch();
        }
        Ok(true)
    }

    /// Looks at the pose in the last step, the second of the pair, or after it. Whether the step, of which
    /// `self.step_start` is the beginning, is too long for a pose that is nearly singular.
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
        if let Some(Foreseen::Singular(known)) = self.foreseen()
            && (time - known).abs() < second
        {
            return Ok(Some(false));
        }
        let behind = pose < length;
        // Beyond the end of the step the cubic is not exact: the pose is looked at from the next one, if it is no other.
        let within = if behind { SAME } else { ALIKE };
        if self.is_known(&self.step_start, (pose - first) / second, within) {
            return Ok(Some(false));
        }
        let kept = self.keep();
        if behind {
            std::mem::swap(&mut self.pair_start, &mut self.step_start);
            self.pair_end.copy_from(self.integrator.state());
        } else {
            self.pair_start.copy_from(self.integrator.state());
        }
        let window = match behind {
            true => [first, length],
            false => [length, length + 2.0 * NEAR_AHEAD * second],
        };
        let found = self.find(passage, pose, window);
        let end = if behind {
            &self.pair_end
        } else {
            &self.pair_start
        };
        self.integrator.state_mut().copy_from(end);
        if behind {
            std::mem::swap(&mut self.pair_start, &mut self.step_start);
        }
        self.restore(kept)?;
        let [_, _, end] = passage.margins;
        Ok(match found? {
            Pose::Turn { least, rate } if PART * least < rate * second => {
                self.expect_pose(Some(Foreseen::Turn { least, rate }));
                Some(behind || end.least < LEAP * least)
            }
            Pose::Singular => {
                self.expect_pose(Some(Foreseen::Singular(time)));
                Some(false)
            }
            Pose::Turn { .. } => Some(false),
            Pose::Unclear => None,
        })
    }

    /// Steps over `span` seconds, each a part of the time in which σ would fall to zero at this rate. Where one of them
    /// fails, or comes to a singular pose, none is taken, and the answer is false. Where σ falls far below the least one that was
    /// foreseen, the pose is singular after all.
    #[cold]
    #[inline(never)]
    fn turn_past(&mut self, span: f64, least: f64, rate: f64) -> Result<bool, SimulationError> {
        self.integrator.state_mut().poses_ahead.last_step = None;
        self.step_start.copy_motion_from(self.integrator.state());
        self.books_at_step_start = self.books;
        // `reach` finds short steps past such a pose by itself.
        let shortest = self.books.shortest;
        let mut left = span;
        while left > 0.0 {
            let h = self.resolving(rate).max(SHORTEST * span);
            let last = h > 0.7 * left;
            let taken = self.advance(if last { left } else { h });
            let singular =
                taken.is_ok() && self.margin().least <= self.least_distinct().max(BELOW * least);
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
        self.books.shortest = shortest;
        Ok(true)
    }

    /// The pose that is near.
    pub(super) fn foreseen(&self) -> Option<Foreseen> {
        self.state().poses_ahead.foreseen
    }

    fn expect_pose(&mut self, pose: Option<Foreseen>) {
        self.integrator.state_mut().poses_ahead.foreseen = pose;
    }

    /// The step that resolves the motion where σ changes at this rate, s.
    pub(super) fn resolving(&mut self, rate: f64) -> f64 {
        PART * self.margin().least / rate
    }
}
