//! A single step where less than one is left, as where a program runs to each instant of a control loop.
//!
//! The length in use was found with earlier pairs, and a shorter step has a smaller error. The stages tell whether this is
//! still so; otherwise a pair is taken ([`tolerance`](super::tolerance)). Methods without an embedded estimate need the pair for a
//! comparison.

use super::Simulation;
use super::comparison::{CLEARLY, Found, UNCOMPARED};
use super::jumps::Previous;
use super::pose::FAR;
use super::step_controller::Pace;
use crate::singular::RankMargin;
use crate::{SimulationError, StepController, System};

/// The way of a single step, in sizes and radians, at most: σ then cannot vanish within it, as it changes by about as much as the
/// mechanism moves, and is larger than [`FAR`] at both ends.
const SHORT: f64 = FAR;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Whether a single step of this length is worth a try.
    pub(super) fn may_be_lone(
        &self,
        left: f64,
        controller: &StepController,
        start: RankMargin,
    ) -> bool {
        let is_known = !controller.searching && controller.estimate_factor > 0.0;
        if !(left < controller.step && is_known && self.follows()) {
            return false;
        }
        let most = match self.pace() {
            Pace::Steps => UNCOMPARED[0],
            Pace::Pairs | Pace::Kept => UNCOMPARED[1],
            Pace::Erratic => return false,
        };
        let is_recent = controller.pairs_since_comparison < most;
        let is_short = (const { Self::UNBRANCHED })
            || start.least > FAR && left * self.yardstick.measure(self.velocities()) < SHORT;
        is_recent && is_short
    }

    /// One step of all that is `left`; `None` if its stages do not show that its error is small enough, or a singular pose may
    /// be in it. The state is then any.
    pub(super) fn lone_step(
        &mut self,
        tolerance: f64,
        left: f64,
        (controller, previous, start): (&StepController, Previous, RankMargin),
    ) -> Result<Option<Found>, SimulationError> {
        let length = match self.guarded_step(left, left) {
            Ok(length) => length,
            Err(error) if error.is_due_to_steps() => return Ok(None),
            Err(error) => return Err(error),
        };
        let Some(estimate) = self.integrator.estimate() else {
            return Ok(None);
        };
        let end = self.margin();
        // Such a passage never foresees a pose; σ at its ends and the short way exclude one.
        let mut found = Found::before([length, 0.0], [start, end, end], &self.balance);
        found.speed = self.speed(length);
        found.work_error = estimate.work;
        let is_within = (const { Self::UNBRANCHED })
            || found.passage.is_far_from_poses() && found.speed * length < SHORT;
        if length != left || !is_within {
            return Ok(None);
        }
        let noise = self.noise_of_velocities(self.noise(start, end), length, controller);
        let allowed = self.allowed(tolerance, length * found.speed.max(controller.speed), noise);
        found.error_ratio = controller.predicted_error_ratio(Some(estimate.error), allowed);
        // Of a pair of such steps, as the difficulties before are of pairs.
        let signs = self.signs(previous, Some(estimate), (2.0 * length, allowed, noise));
        found.estimated_difficulty = signs.and_then(|signs| signs.difficulty());
        let may_jump = signs.is_some_and(|signs| signs.may_jump());
        let is_clear = found.error_ratio <= CLEARLY[usize::from(self.pace() != Pace::Steps)];
        Ok((is_clear && !may_jump).then_some(found))
    }
}
