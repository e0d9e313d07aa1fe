//! Placement: the choice of a step length such that no stage ends beside a singular pose.
//!
//! At a singular pose rows are dependent, and a multiplier is not determined. A pose within a stage does no harm, but a
//! stage that begins or ends beside the pose does. Such a step is repeated with another length.

use super::Simulation;
use super::advance::HALVINGS;
use super::energy_guard::Refused;
use crate::linear::dot;
use crate::{Energy, Method, SimulationError, State, System, alf3f};
use nalgebra::SVector;

/// Clearances as fractions of a step: a step with more than the first is accepted; otherwise a length with at least the
/// second is searched. At second order nearly every clearance is harmless, and a repeated step costs more than it
/// saves. A drive gives the energy for another branch, which the balance then does not show: there the first is that of
/// composed steps.
const SECOND: [f64; 2] = [0.02, 0.15];
/// Composed steps: the length with the largest predicted clearance is taken, and a clearance above the second value is
/// accepted.
const COMPOSED: [f64; 2] = [alf3f::CLEAR, 0.03];
/// Explicit steps, whose stages lie at given fractions of a step.
const EXPLICIT: [f64; 2] = [0.06, 0.1];
/// The number of lengths chosen for a composed step, and the bounds of the length as fractions of the step.
const AIMS: usize = 3;
const BOUNDS: [f64; 2] = [0.5, 1.15];
/// Lengths that are tried, as fractions of the step.
const LENGTHS: [f64; 7] = [0.8, 0.64, 1.15, 0.9, 0.72, 0.5, 0.57];
/// A step to a given instant is not placed when less than this part of a step is left: the instant itself may be that of
/// a singular pose.
const REMAINDER: f64 = 0.1;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// A step of about h, at most `left`; after an error the state is that before it.
    #[inline]
    pub(super) fn given_step(&mut self, h: f64, left: f64) -> Result<(), SimulationError> {
        self.poses_at_step_start = self.state().poses_ahead;
        if !self.is_free() {
            // With the fields that only some methods carry from step to step.
            self.step_start.copy_from(self.integrator.state());
            self.books_at_step_start = self.books;
        }
        match self.guarded_step(h, left) {
            Ok(_) => Ok(()),
            Err(error) => Err(self.undone(error)),
        }
    }

    /// After a step that has failed: goes back to its beginning.
    #[cold]
    #[inline(never)]
    fn undone(&mut self, error: SimulationError) -> SimulationError {
        if !self.is_free() {
            self.integrator.state_mut().copy_from(&self.step_start);
        }
        // If that fails, too, the first error tells more.
        let _ = self.back();
        self.integrator.state_mut().poses_ahead = self.poses_at_step_start;
        self.balance = self.energy();
        self.multipliers_before = Some(None);
        error
    }

    /// A step of about h, at most `left`, with placement; returns its length.
    pub(super) fn guarded_step(&mut self, h: f64, left: f64) -> Result<f64, SimulationError> {
        let before = self.balance;
        let length = self.step_past_poses(h, left)?;
        match self.refused_after(&before) {
            None => Ok(length),
            Some(refused) => self.take_in_parts(h, left, (length, refused), &before),
        }
    }

    /// Why the energy balance after a step is refused, if it is; `before` is that before the step.
    #[inline]
    fn refused_after(&mut self, before: &Energy) -> Option<Refused> {
        let range = self.integrator.state_mut().ledger.range.as_mut()?;
        self.energy_guard.refuses(range, &self.balance, before)
    }

    /// After a step whose energy balance is refused: a shorter one, if the error is due to the rows of the step and it
    /// helps.
    #[cold]
    #[inline(never)]
    fn take_in_parts(
        &mut self,
        h: f64,
        left: f64,
        (mut length, refused): (f64, Refused),
        before: &Energy,
    ) -> Result<f64, SimulationError> {
        if !self.balance.error.is_finite() {
            let (time, what) = (self.time() - length, "energy");
            return Err(SimulationError::NonFinite { time, what });
        }
        let free = self.is_free() && self.settings.tolerance.is_none();
        if refused
            .leapt
            .is_some_and(|by| free && by > self.error_of_forces())
        {
            for halvings in 1..=HALVINGS {
                self.back()?;
                self.rejected += 1;
                if !self.settings.placement {
                    self.balance = self.energy();
                    if self.in_parts(h, 1 << halvings)? {
                        return Ok(h);
                    }
                    continue;
                }
                let part = h / f64::from(1 << halvings);
                let Ok(shorter) = self.step_past_poses(part, left) else {
                    continue;
                };
                if self.refused_after(before).is_none() {
                    return Ok(shorter);
                }
            }
            self.back()?;
            length = self.step_past_poses(h, left)?;
        }
        match refused.wrong {
            true => Err(self.nonsense(length, refused.available)),
            false => Ok(length),
        }
    }

    /// A step of h in equal parts, with placement off; whether all of them are accepted. Otherwise the state is that before it.
    fn in_parts(&mut self, h: f64, count: u32) -> Result<bool, SimulationError> {
        for _ in 0..count {
            let before = self.balance;
            let is_taken = match self.advance(h / f64::from(count)) {
                Ok(_) => self.refused_after(&before).is_none(),
                Err(error) if error.asks_for_less() => false,
                Err(error) => return Err(error),
            };
            if !is_taken {
                self.back()?;
                return Ok(false);
            }
            self.watch();
        }
        Ok(true)
    }

    /// A bound of the energy that forces have given or taken too late in the last step, J: none if they are constant. Where
    /// a spring vibrates within the step this is larger than its energy.
    fn error_of_forces(&self) -> f64 {
        let forces = |state: &State<Q, N, R>| {
            let mut forces: SVector<f64, N> = SVector::zeros();
            let (q, v) = (&state.positions, &state.velocities);
            self.system().applied_forces(state.time, q, v, &mut forces);
            forces
        };
        let (begin, end) = (&self.step_start, self.state());
        let change = forces(end) - forces(begin);
        let way = (begin.velocities.abs() + end.velocities.abs()) * (0.5 * (end.time - begin.time));
        dot(&change.abs(), &way)
    }

    #[cold]
    fn nonsense(&self, step: f64, available: f64) -> SimulationError {
        let (time, error) = (self.time(), self.balance.error);
        let adaptive = self.settings.tolerance.is_some();
        match error > 0.0 {
            true => SimulationError::EnergyGain {
                time,
                step,
                gained: error,
                available,
                adaptive,
            },
            false => SimulationError::EnergyLoss {
                time,
                step,
                lost: -error,
                available,
                adaptive,
            },
        }
    }

    /// Whether steps may be divided or have other lengths.
    pub(super) fn is_free(&self) -> bool {
        let watches = matches!(self.settings.method, Method::TwoLevel | Method::Projected);
        watches && self.settings.fixed_iterations.is_none()
    }

    /// The clearance below which a step suffers from a singular pose.
    pub(super) fn clear(&self) -> f64 {
        self.clearances()[0]
    }

    /// The clearance that is left as it is, and the one that is looked for.
    fn clearances(&self) -> [f64; 2] {
        match (self.settings.method, self.settings.order) {
            (Method::Projected, _) => EXPLICIT,
            (_, 2) if const { S::STRUCTURE.rheonomic } => [alf3f::CLEAR, SECOND[1]],
            (_, 2) => SECOND,
            _ => COMPOSED,
        }
    }

    #[inline(always)]
    pub(super) fn placed_step(&mut self, h: f64, left: f64) -> Result<f64, SimulationError> {
        // A pair that is taken back begins with its own state.
        let is_unplaced = const { Self::UNBRANCHED } && self.is_paced_by_estimates();
        if is_unplaced || !self.is_free() {
            self.advance(h)?;
            return Ok(h);
        }
        self.step_start.copy_motion_from(self.integrator.state());
        self.books_at_step_start = self.books;
        if !self.settings.placement || h < REMAINDER * self.nominal() {
            self.advance(h)?;
            return Ok(h);
        }
        let first = self.advance(h);
        let wanted = self.clear();
        match first {
            Ok(clearance) if !(clearance < wanted) => Ok(h),
            // Without a clearance nothing is known of singular poses.
            Err(error) if !error.asks_for_less() || self.is_paced_by_estimates() => Err(error),
            _ => self.choose(h, left, first),
        }
    }

    /// Tries other lengths after `first`, and takes the first that keeps clear or else the best.
    #[cold]
    #[inline(never)]
    fn choose(
        &mut self,
        h: f64,
        left: f64,
        first: Result<f64, SimulationError>,
    ) -> Result<f64, SimulationError> {
        let (mut best, mut length) = match &first {
            Ok(clearance) => (*clearance, h),
            Err(_) => (f64::NEG_INFINITY, h),
        };
        let (mut taken, mut aims) = (h, 0);
        for (factor, expected) in self.promising_lengths() {
            // After one attempt with all its stages the position of the pose is known, and the length of a composed
            // step can be computed.
            let bounds = [BOUNDS[0] * h, (BOUNDS[1] * h).min(left)].map(|bound| bound / taken);
            let aimed = self.integrator.aim(bounds);
            let trial = match aimed {
                Some((_, clearance)) if aims >= AIMS || !(clearance > best) => break,
                Some((factor, _)) => (factor * taken).min(left),
                None if expected <= best => break,
                None => factor * h,
            };
            if trial > left {
                continue;
            }
            aims += usize::from(aimed.is_some());
            self.back()?;
            taken = trial;
            match self.advance(trial) {
                Ok(clearance) if clearance > best => (best, length) = (clearance, trial),
                _ => {}
            }
            if best >= self.clearances()[1] {
                break;
            }
        }
        if best == f64::NEG_INFINITY {
            self.back()?;
            return first.map(|_| h);
        }
        if taken != length {
            self.back()?;
            self.advance(length)?;
        }
        self.placed += u64::from(length != h);
        Ok(length)
    }

    /// [`LENGTHS`] in their order, with NaN; after an explicit step, whose stages tell where the pose is, with the expected
    /// clearances, the largest first.
    fn promising_lengths(&self) -> [(f64, f64); LENGTHS.len()] {
        let mut lengths =
            LENGTHS.map(|factor| (factor, self.integrator.expected_clearance(factor)));
        match lengths.iter().all(|(_, clearance)| clearance.is_finite()) {
            true => sort_by_clearance(&mut lengths),
            false => lengths = LENGTHS.map(|factor| (factor, f64::NAN)),
        }
        lengths
    }

    /// Restores the state before the step.
    pub(super) fn back(&mut self) -> Result<(), SimulationError> {
        self.integrator
            .state_mut()
            .copy_motion_from(&self.step_start);
        self.books = self.books_at_step_start;
        self.rank_margin = None;
        self.integrator.refresh(&self.settings)
    }
}

/// The largest clearance first. (Outside of generic functions, as [`Probe::sort`](super::pose::Probe::sort).)
fn sort_by_clearance(lengths: &mut [(f64, f64)]) {
    lengths.sort_unstable_by(|a, b| b.1.total_cmp(&a.1));
}
