//! What the energy balance tells of a pair of steps, which comparisons do not.

use super::Simulation;
use super::comparison::Found;
use super::step_controller::TOO_LONG;
use crate::singular::ROUND_OFF;
use crate::state::rounding;
use crate::{Energy, System};
use nalgebra::SVector;

/// Steps of any length agree about a motion that rows of time determine, and may agree about another branch beyond a singular
/// pose. What tells them apart is the energy balance: a pair may be wrong by this part of the kinetic energy, or of the work
/// of forces without potential (in regular poses a driven mechanism has the tolerance instead of this part), …
const BALANCED: f64 = 0.02;
/// … and the velocities of a driven mechanism may change by this part of the speed past a singular pose, …
const TURNED: f64 = 0.5;
/// … unless it moves less than this, in sizes and radians: where a force jumps the balance is wrong in any step.
const NEARBY: f64 = 0.002;
/// Where the velocity of a drive jumps, the work of a pair is wrong however short it is; where only its acceleration jumps, the
/// error falls with the length. So the tolerance does not judge the work of pairs that move less than this many times the tolerance, …
const JUMPED: f64 = 4.0;
/// … or less than this, in sizes and radians; …
const LEAST_WAY: f64 = 1e-9;
/// … that are shorter than so many of the shortest ones, …
const SHORT: f64 = 8.0;
/// … or than so many times the round-off of the clock.
const NEXT_TO_CLOCK: f64 = 1e4;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The ratio of the error of the energy balance in the pair to the allowed one; [`TOO_LONG`] where a driven mechanism, whose
    /// balance does not show it, may have turned into another branch. No pair is made shorter than `shortest`, s.
    ///
    /// Where rows of time determine the motion, positions are exact with steps of any length, but the works of drives and forces
    /// are not: they are sums over the stages. The balance shows the error of the drives alone, since each gives what a force
    /// takes in the same stage; that of the forces is estimated.
    pub(super) fn imbalance(
        &self,
        tolerance: f64,
        before: &Energy,
        found: &Found,
        shortest: f64,
    ) -> f64 {
        let [first, second] = found.passage.steps;
        let length = first + second;
        let way = found.speed * length;
        let is_judged = match const { Self::DRIVEN } {
            true => {
                let short = (SHORT * shortest).max(NEXT_TO_CLOCK * rounding(self.time()));
                way >= (JUMPED * tolerance).max(LEAST_WAY) && length > short
            }
            false => way >= NEARBY,
        };
        if !is_judged && way < NEARBY {
            return 0.0;
        }
        let now = &self.balance;
        let work = (now.nonconservative_work - before.nonconservative_work).abs();
        let turnover = before.kinetic.max(now.kinetic).max(work);
        let of = |error: f64| (error - before.error).abs();
        let error = of(now.error).max(of(found.imbalance));
        // The clock shows the time of the pair, and with it the work of drives, with this relative error.
        let clock = match const { Self::DRIVEN } {
            true => rounding(self.time()) / length,
            false => 0.0,
        };
        let error_ratio = match way >= NEARBY {
            true => error / ((BALANCED + clock) * turnover),
            false => 0.0,
        };
        let error_ratio = match (const { Self::DRIVEN }, found.passage.foreseen().is_some()) {
            (true, true) if way >= NEARBY && self.turns() => TOO_LONG,
            (true, false) if is_judged => {
                let error = error.max(found.work_error);
                let turnover = turnover.max((now.drive_work - before.drive_work).abs());
                let whole = now.kinetic + now.potential.abs() + now.drive_work.abs();
                error_ratio.max(error / ((tolerance + clock) * turnover + ROUND_OFF * whole))
            }
            _ => error_ratio,
        };
        error_ratio.min(TOO_LONG)
    }

    /// The change of the error of the balance, as a multiple of what the tolerance allows, of a driven mechanism: in steps that
    /// are nearly too long the work of a drive is right for some lengths, and far off for others.
    pub(super) fn imbalance_since(&self, end: &Energy) -> f64 {
        let (true, Some(tolerance)) = (const { Self::DRIVEN }, self.settings.tolerance) else {
            return 0.0;
        };
        let now = &self.balance;
        let whole = now.kinetic + now.potential.abs() + now.drive_work.abs();
        let allowed = tolerance * now.kinetic.max(end.kinetic) + ROUND_OFF * whole;
        match (now.error - end.error).abs() {
            error if error <= allowed => 0.0,
            error => error / allowed,
        }
    }

    /// Whether the velocities change in the pair so much that it may have turned into another branch. A drive gives the
    /// energy for that.
    fn turns(&self) -> bool {
        let (before, now) = (&self.pair_start.velocities, self.velocities());
        let measure = |v: &SVector<f64, N>| self.yardstick.measure(v);
        measure(&(now - before)) > TURNED * measure(now).max(measure(before))
    }
}
