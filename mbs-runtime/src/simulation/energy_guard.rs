//! The check that a motion does not gain energy without a source.
//!
//! The kinetic energy is at most what the start and the works have given, above the least potential energy. Steps that
//! are too long for the motion, or for a stiff spring, may gain many times this, and go on. Errors of coarse steps are
//! of its size at most; ten times as much is nonsense.

use crate::linear::vector;
use crate::sink::{Diagonal, Discard};
use crate::yardstick::Yardstick;
use crate::{Energy, State, System};
use nalgebra::SVector;

/// The error of the energy balance that is refused, as a multiple of the energy that the motion has. Coarse steps
/// through singular poses have reached 1.
const GROSS: f64 = 10.0;
/// Round-off of displacements in a step, in sizes of the mechanism: with less energy than such a motion has nothing is
/// refused.
const NOISE: f64 = 1e-9;

/// The energy that the motion has, J.
#[derive(Debug, Clone, Copy)]
pub(super) struct EnergyGuard {
    /// The energy that the forces at the start give along the size of the mechanism, or until they are at ease.
    depth: f64,
    /// The least potential energy so far.
    least: f64,
    /// The largest works so far.
    works: f64,
    /// Round-off.
    noise: f64,
    /// What is gross in any case, so that most steps compare this only.
    least_gross: f64,
}

impl EnergyGuard {
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        system: &S,
        state: &State<Q, N, R>,
        yardstick: &Yardstick<Q, N>,
        step: f64,
    ) -> Self {
        let (q, v) = (&state.positions, &state.velocities);
        let mut mass = Diagonal::<N>::zeros();
        system.mass_matrix(q, &mut mass);
        let mut force = SVector::zeros();
        system.applied_forces(state.time, q, v, &mut force);
        let mut f_q = Diagonal::<N>::zeros();
        system.applied_force_tangents(state.time, q, v, &mut f_q, &mut Discard);
        let unit = yardstick.displacement(vector(|_| 1.0));
        let speed = NOISE / step;
        let along = |i: usize| {
            let way = (0.5 * force[i] / f_q.0[i]).abs();
            force[i].abs() * if way < unit[i] { way } else { unit[i] }
        };
        let depth = (0..N).map(along).sum();
        let noise = (0..N).map(|i| mass.0[i] * (speed * unit[i]).powi(2)).sum();
        EnergyGuard {
            depth,
            least_gross: GROSS * (depth + noise),
            least: f64::INFINITY,
            works: 0.0,
            noise,
        }
    }

    /// The energy that the motion has, if the error of the balance is out of all proportion to it.
    #[inline]
    pub(super) fn gained(&mut self, energy: &Energy) -> Option<f64> {
        if energy.potential < self.least {
            self.least = energy.potential;
        }
        let works = energy.nonconservative_work.abs() + energy.drive_work.abs();
        if works > self.works {
            self.works = works;
        }
        if energy.error <= self.least_gross {
            return None;
        }
        let initial = energy.kinetic + energy.potential
            - energy.error
            - energy.nonconservative_work
            - energy.drive_work;
        let given = initial - self.least + initial.abs();
        let available = given + self.depth + self.works + self.noise;
        (energy.error > GROSS * available).then_some(available)
    }
}
