//! The check that a motion does not gain energy without a source, and does not lose it without a brake.
//!
//! The kinetic energy is at most what the start and the works have given, above the least potential energy. Steps that
//! are too long for the motion, or for a stiff spring, may gain many times this or lose nearly all of it, and go on.
//! Two-level steps have oscillating errors, of some hundredths for coarse steps: an error of a fifth says that the
//! steps do not follow the motion. Where works belong to the balance they count among what the motion has, and the error
//! of their quadrature is allowed besides, as far as the ends of the steps show it (in a step in which a stiff damper stops a part
//! the trapezoidal rule is far from its work), and a part of all works without their signs. For methods that do not conserve
//! energy, and for drives, whose rates may jump, ten times what the motion has is nonsense; only for the projected method, where
//! no force does work beside the potentials, a fifth is too much as well.
//!
//! A two-level step that makes a tenth of this error by itself, without forces that change in it, has leapt over a turn of the
//! motion, or turned into another branch past a singular pose: it is taken in shorter ones (`placement.rs`). Where a drive
//! jumps shorter ones do not help, and the step is kept. A projected step is taken in shorter ones if it makes most of an error
//! of a fifth: then a stage of high order has ended beside a singular pose that placement did not see.

use crate::linear::vector;
use crate::sink::{Diagonal, Discard};
use crate::yardstick::Yardstick;
use crate::{Energy, EnergyRange, Method, Settings, State, System};
use nalgebra::SVector;

/// The gain of energy that is refused, as a multiple of the energy that the motion has. Coarse steps through singular
/// poses have reached 1 with some methods.
const GROSS: f64 = 10.0;
/// The same of gains and losses with two-level steps, and with projected ones. A smaller value refuses coarse runs that are
/// useful, a larger one accepts runs that are not.
///
/// Of 5363 random runs without this check (`--example sweep` of `mbs-examples`) 214 exceed it. Three of these end within
/// a hundredth of the size from the motion; in two the energy of a spring that vibrates by a ten-thousandth is wrong. Of
/// the 62 runs between a tenth and a fifth thirteen end within a tenth of the size.
const WRONG: f64 = 0.2;
/// The same of a single step: with more it leaps over a part of the motion, as where a mechanism that folds up has little
/// inertia in one pose, and turns back within the step. A smaller value shortens coarse steps that are useful, a larger one
/// leaves less of [`WRONG`] to the steps after it.
const LEAPT: f64 = 0.02;
/// The error of the works that is accepted, as a part of all that was given and taken back: where inputs jump, or a controller
/// switches, the error of the trapezoidal rule has the same sign each time, and adds up while the works cancel. (A block on a spring
/// and a damper, whose other end jumps twice a second, has 0.9 % with ω h = 0.24, and 0.003 % with 0.014.)
const MEASURED: f64 = 0.05;
/// Round-off of displacements in a step, in sizes of the mechanism: with less energy than such a motion has nothing is
/// refused.
const NOISE: f64 = 1e-9;

/// What is accepted, J. What the motion has had is in its state ([`EnergyRange`]), so that steps that are taken back are no part of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct EnergyGuard {
    /// Round-off.
    noise: f64,
    method: Method,
    /// What is accepted in any case, so that most steps compare this only.
    accepted: f64,
}

/// What the balance after a step is refused for.
pub(super) struct Refused {
    /// The energy that the motion has, J.
    pub(super) available: f64,
    /// The error is out of proportion to it.
    pub(super) wrong: bool,
    /// The error of the last step alone, J, if the step should be taken in shorter ones.
    pub(super) leapt: Option<f64>,
}

impl EnergyRange {
    /// Where a balance begins.
    fn starting<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        system: &S,
        state: &State<Q, N, R>,
        unit: &SVector<f64, N>,
    ) -> Self {
        let (q, v) = (&state.positions, &state.velocities);
        let mut force = SVector::zeros();
        system.applied_forces(state.time, q, v, &mut force);
        let mut f_q = Diagonal::<N>::zeros();
        system.applied_force_tangents(state.time, q, v, &mut f_q, &mut Discard);
        let along = |i: usize| {
            let way = (0.5 * force[i] / f_q.0[i]).abs();
            force[i].abs() * if way < unit[i] { way } else { unit[i] }
        };
        let depth: f64 = (0..N).map(along).sum();
        EnergyRange {
            depth,
            least: system.potential_energy(q) - depth,
            works: 0.0,
            doubts: 0.0,
            exchanged: 0.0,
        }
    }

    /// Takes note of how far the works of a step may be from those of the forces, J.
    #[inline]
    pub(super) fn doubt(&mut self, works: f64) {
        if works.is_finite() {
            self.doubts += works * works;
        }
    }

    /// Takes note of the works of a step, without their signs, J.
    #[inline]
    pub(super) fn exchange(&mut self, works: f64) {
        if works.is_finite() {
            self.exchanged += works;
        }
    }

    /// Takes note of a balance that is accepted.
    #[inline(always)]
    pub(super) fn note(&mut self, energy: &Energy) {
        if energy.potential < self.least {
            self.least = energy.potential;
        }
        let works = works_of(energy);
        if works > self.works {
            self.works = works;
        }
    }
}

impl EnergyGuard {
    /// For a motion that goes on from this state, with its range, which is taken here if the state does not have it.
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        system: &S,
        state: &State<Q, N, R>,
        yardstick: &Yardstick<Q, N>,
        settings: &Settings,
    ) -> (Self, EnergyRange) {
        // A state has no energy.
        let unit = yardstick.displacement(vector(|_| 1.0));
        let unit: SVector<f64, N> = vector(|i| match yardstick.is_motion(i) {
            true => unit[i],
            false => 0.0,
        });
        let range = match state.ledger.range {
            Some(range) => range,
            None => EnergyRange::starting(system, state, &unit),
        };
        let mut mass = Diagonal::<N>::zeros();
        system.mass_matrix(&state.positions, &mut mass);
        let speed = NOISE / settings.step;
        let noise: f64 = (0..N).map(|i| mass.0[i] * (speed * unit[i]).powi(2)).sum();
        let bound = match settings.method {
            Method::TwoLevel => LEAPT,
            Method::Projected => WRONG,
            _ => GROSS,
        };
        let guard = EnergyGuard {
            noise,
            method: settings.method,
            accepted: match const { S::STRUCTURE.rheonomic } && settings.method == Method::TwoLevel
            {
                // A step is judged by its kinetic energy, which may be much less.
                true => bound * noise,
                false => bound * (range.depth + noise),
            },
        };
        (guard, range)
    }

    /// Why the balance is refused, if it is. `before`: that before the last step.
    #[inline]
    pub(super) fn refuses(
        &self,
        range: &mut EnergyRange,
        energy: &Energy,
        before: &Energy,
    ) -> Option<Refused> {
        if energy.error.abs() <= self.accepted {
            range.note(energy);
            return None;
        }
        let refused = self.judge(range, energy, before);
        if refused.is_none() {
            // What a refused step has reached is no part of the motion.
            range.note(energy);
        }
        refused
    }

    #[cold]
    fn judge(&self, range: &EnergyRange, energy: &Energy, before: &Energy) -> Option<Refused> {
        let doubtful = range.doubts.sqrt();
        let initial = energy.kinetic + energy.potential
            - energy.error
            - energy.nonconservative_work
            - energy.drive_work;
        // The least of the motion and that of the forces at the start do not add up: a spring that is stretched at the start gives
        // what it has once.
        let above = initial - range.least.min(energy.potential);
        let available = above + range.works.max(works_of(energy)) + self.noise;
        let error = energy.error.abs();
        let by = (energy.error - before.error).abs();
        let driven = energy.drive_work != 0.0;
        let strict = match self.method {
            Method::TwoLevel => !driven,
            Method::Projected => !driven && energy.nonconservative_work == 0.0,
            _ => false,
        };
        // What a drive has given so far is no measure of a step.
        let turnover = match driven {
            true => before.kinetic.max(energy.kinetic),
            false => available,
        };
        let wrong = match strict {
            // NaN is wrong, too.
            true => !(error <= WRONG * available + doubtful + MEASURED * range.exchanged),
            false => !(energy.error <= GROSS * (available + initial.abs())),
        };
        let has_leapt = match self.method {
            Method::TwoLevel => by > LEAPT * turnover + doubtful,
            // The bound of two-level steps would refuse long explicit steps that are useful.
            Method::Projected => strict && wrong && by > 0.5 * error,
            _ => false,
        };
        let refused = Refused {
            available,
            wrong,
            leapt: has_leapt.then_some(by),
        };
        (refused.wrong || refused.leapt.is_some()).then_some(refused)
    }
}

fn works_of(energy: &Energy) -> f64 {
    energy.nonconservative_work.abs() + energy.drive_work.abs()
}

#[cfg(test)]
mod tests {
    use super::EnergyGuard;
    use crate::{Energy, EnergyRange, Method};

    /// A motion that has 100 J; its balance has an error of 30 J now, and had one of `before`.
    fn judged(method: Method, before: f64, exchanged: f64) -> Option<(bool, Option<f64>)> {
        let guard = EnergyGuard {
            noise: 0.0,
            method,
            accepted: 0.0,
        };
        let range = EnergyRange {
            depth: 50.0,
            least: -50.0,
            exchanged,
            ..EnergyRange::default()
        };
        let before = Energy {
            kinetic: 50.0,
            error: before,
            ..Energy::default()
        };
        let energy = Energy {
            kinetic: 80.0,
            potential: 0.0,
            error: 30.0,
            ..Energy::default()
        };
        let refused = guard.judge(&range, &energy, &before)?;
        Some((refused.wrong, refused.leapt))
    }

    #[test]
    fn a_projected_step_with_most_of_an_error_that_ends_the_run_has_leapt() {
        let of = |method, before| judged(method, before, 0.0).expect("a fifth is wrong");
        assert_eq!(of(Method::Projected, 1.0), (true, Some(29.0)));
        assert_eq!(of(Method::Projected, 25.0), (true, None));
        assert_eq!(of(Method::TwoLevel, 25.0), (true, Some(5.0)));
    }

    #[test]
    fn a_small_part_of_the_works_may_be_wrong() {
        let is_wrong = |exchanged| {
            let refused = judged(Method::TwoLevel, 29.0, exchanged);
            refused.is_some_and(|(wrong, _)| wrong)
        };
        assert!(is_wrong(100.0));
        assert!(!is_wrong(400.0));
    }
}
