//! The check that a motion does not gain energy without a source, and does not lose it without a brake.
//!
//! The kinetic energy is at most what the start and the works have given, above the least potential energy. Steps that
//! are too long for the motion, or for a stiff spring, may gain many times this or lose nearly all of it, and go on.
//! Two-level steps have oscillating errors, of some hundredths for coarse steps: an error of a fifth says that the
//! steps do not follow the motion. Where works belong to the balance they count among what the motion has, and the error
//! of their quadrature is allowed besides: in a step in which a stiff damper stops a part the trapezoidal rule is far from
//! its work. For methods that do not conserve energy, and for drives, whose rates may jump, ten times what the motion has
//! is nonsense; only for the projected method, where no force does work beside the potentials, a fifth is too much as well.
//!
//! A two-level step that makes a tenth of this error by itself, without forces that change in it, has leapt over a turn of the
//! motion, or turned into another branch past a singular pose: it is taken in shorter ones (`placement.rs`). Where a drive
//! jumps shorter ones do not help, and the step is kept. A projected step is taken in shorter ones if it makes most of an error
//! of a fifth: then a stage of high order has ended beside a singular pose that placement did not see.

use super::books::Books;
use crate::linear::vector;
use crate::sink::{Diagonal, Discard};
use crate::yardstick::Yardstick;
use crate::{Energy, Method, Settings, State, System};
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
/// Round-off of displacements in a step, in sizes of the mechanism: with less energy than such a motion has nothing is
/// refused.
const NOISE: f64 = 1e-9;

/// The energy that the motion has, J.
#[derive(Debug, Clone, Copy)]
pub(super) struct EnergyGuard {
    /// The potential energy at the start.
    start: f64,
    /// The energy that the forces at the start give along the size of the mechanism, or up to where a linear force vanishes.
    depth: f64,
    /// The least potential energy so far.
    least: f64,
    /// The kinetic energy before the step.
    kinetic: f64,
    /// The largest works so far.
    works: f64,
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

impl EnergyGuard {
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        system: &S,
        state: &State<Q, N, R>,
        yardstick: &Yardstick<Q, N>,
        settings: &Settings,
    ) -> Self {
        let (q, v) = (&state.positions, &state.velocities);
        let mut mass = Diagonal::<N>::zeros();
        system.mass_matrix(q, &mut mass);
        let mut force = SVector::zeros();
        system.applied_forces(state.time, q, v, &mut force);
        let mut f_q = Diagonal::<N>::zeros();
        system.applied_force_tangents(state.time, q, v, &mut f_q, &mut Discard);
        // A state has no energy.
        let unit = yardstick.displacement(vector(|_| 1.0));
        let unit: SVector<f64, N> = vector(|i| match yardstick.is_motion(i) {
            true => unit[i],
            false => 0.0,
        });
        let speed = NOISE / settings.step;
        let along = |i: usize| {
            let way = (0.5 * force[i] / f_q.0[i]).abs();
            force[i].abs() * if way < unit[i] { way } else { unit[i] }
        };
        let depth = (0..N).map(along).sum();
        let noise = (0..N).map(|i| mass.0[i] * (speed * unit[i]).powi(2)).sum();
        let bound = match settings.method {
            Method::TwoLevel => LEAPT,
            Method::Projected => WRONG,
            _ => GROSS,
        };
        EnergyGuard {
            start: system.potential_energy(q),
            depth,
            method: settings.method,
            accepted: match const { S::STRUCTURE.rheonomic } && settings.method == Method::TwoLevel
            {
                // A step is judged by its kinetic energy, which may be much less.
                true => bound * noise,
                false => bound * (depth + noise),
            },
            least: f64::INFINITY,
            works: 0.0,
            kinetic: 0.0,
            noise,
        }
    }

    /// What the motion has had before its method changed.
    pub(super) fn take_over(&mut self, before: &Self) {
        *self = EnergyGuard {
            noise: self.noise,
            method: self.method,
            accepted: self.accepted,
            ..*before
        };
    }

    /// Why the balance is refused, if it is. `before`: its error before the last step.
    #[inline]
    pub(super) fn refuses(
        &mut self,
        energy: &Energy,
        books: &Books,
        before: f64,
    ) -> Option<Refused> {
        if energy.error.abs() <= self.accepted {
            self.note(energy);
            return None;
        }
        self.judge(energy, books.doubtful_work(), before)
    }

    #[inline(always)]
    pub(super) fn note(&mut self, energy: &Energy) {
        self.kinetic = energy.kinetic;
        if energy.potential < self.least {
            self.least = energy.potential;
        }
        let works = works_of(energy);
        if works > self.works {
            self.works = works;
        }
    }

    #[cold]
    fn judge(&mut self, energy: &Energy, doubtful: f64, before: f64) -> Option<Refused> {
        let initial = energy.kinetic + energy.potential
            - energy.error
            - energy.nonconservative_work
            - energy.drive_work;
        let least = self.least.min(energy.potential);
        // Both are energies above a minimum. They do not add up: a spring that is stretched at the start gives what it has
        // once.
        let above = (initial - least).max(initial - self.start + self.depth);
        let available = above + self.works.max(works_of(energy)) + self.noise;
        let error = energy.error.abs();
        let by = (energy.error - before).abs();
        let driven = energy.drive_work != 0.0;
        let strict = match self.method {
            Method::TwoLevel => !driven,
            Method::Projected => !driven && energy.nonconservative_work == 0.0,
            _ => false,
        };
        // What a drive has given so far is no measure of a step.
        let turnover = match driven {
            true => self.kinetic.max(energy.kinetic),
            false => available,
        };
        let wrong = match strict {
            // NaN is wrong, too.
            true => !(error <= WRONG * available + doubtful),
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
        if refused.wrong || refused.leapt.is_some() {
            // What a refused step has reached is no part of the motion.
            return Some(refused);
        }
        self.note(energy);
        None
    }
}

fn works_of(energy: &Energy) -> f64 {
    energy.nonconservative_work.abs() + energy.drive_work.abs()
}

#[cfg(test)]
mod tests {
    use super::EnergyGuard;
    use crate::{Energy, Method};

    /// A motion that has 100 J; its balance has an error of 30 J now, and had one of `before`.
    fn judged(method: Method, before: f64) -> (bool, Option<f64>) {
        let mut guard = EnergyGuard {
            start: 0.0,
            depth: 50.0,
            least: 0.0,
            kinetic: 50.0,
            works: 0.0,
            noise: 0.0,
            method,
            accepted: 0.0,
        };
        let energy = Energy {
            kinetic: 80.0,
            potential: 0.0,
            error: 30.0,
            ..Energy::default()
        };
        let refused = guard.judge(&energy, 0.0, before).expect("a fifth is wrong");
        (refused.wrong, refused.leapt)
    }

    #[test]
    fn a_projected_step_with_most_of_an_error_that_ends_the_run_has_leapt() {
        assert_eq!(judged(Method::Projected, 1.0), (true, Some(29.0)));
        assert_eq!(judged(Method::Projected, 25.0), (true, None));
        assert_eq!(judged(Method::TwoLevel, 25.0), (true, Some(5.0)));
    }
}
