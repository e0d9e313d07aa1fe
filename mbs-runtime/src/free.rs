//! The motion without rows, at an instant.

use crate::sink::Discard;
use crate::{MatrixSink, System};
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

/// F − ṗ|_v, what M v̇ is without rows.
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
    system.forces(t, q, v, result);
    if !S::STRUCTURE.constant_mass {
        // ṗ = M v̇ + (∂p/∂q) v.
        let mut change = Product { v, result };
        system.force_tangents(t, q, v, &mut Discard, &mut Discard, &mut change);
    }
}

/// Subtracts the product of the matrix written to it and v.
struct Product<'a, const N: usize> {
    v: &'a SVector<f64, N>,
    result: &'a mut SVector<f64, N>,
}

impl<const N: usize> MatrixSink for Product<'_, N> {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.result[row] -= value * self.v[column];
    }
}
