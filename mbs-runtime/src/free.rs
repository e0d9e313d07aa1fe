//! The motion without rows, at an instant.

use crate::System;
use nalgebra::SVector;

/// M⁻¹(f − Γvv), the acceleration without rows.
#[inline(always)]
pub(crate) fn free<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    mass: &S::Mass,
    t: f64,
    q: &SVector<f64, Q>,
    v: &SVector<f64, N>,
) -> SVector<f64, N> {
    let mut result = crate::linear::zeros();
    if S::STRUCTURE.constant_mass && !S::STRUCTURE.velocity_forces && S::ROTATIONS.is_empty() {
        system.acceleration(t, q, &mut result);
        return result;
    }
    write_free_forces(system, t, q, v, &mut result);
    system.solve_mass(mass, &mut result);
    result
}

/// F − ṗ|_v, M v̇ without rows.
#[inline(always)]
pub(crate) fn write_free_forces<S, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    q: &SVector<f64, Q>,
    v: &SVector<f64, N>,
    result: &mut SVector<f64, N>,
) where
    S: System<Q, N, R>,
{
    match S::STRUCTURE.constant_mass {
        true => system.forces(t, q, v, result),
        false => system.free_forces(t, q, v, result),
    }
}
