//! The mass matrix and quantities that are computed from it.

use crate::{MatrixSink, TensorSink};
use nalgebra::SVector;

/// M(q) of a mechanism with Q coordinates and N velocities.
pub trait Inertia<const Q: usize, const N: usize>: Clone {
    /// A factor of M(q): empty if M is constant (the system has its inverse, or the factor of a large M), else D⁻¹ and the
    /// entries of L of M = L D Lᵀ, or a Cholesky factor of a long one.
    type Mass: Clone + Send + Sync + 'static;

    /// M(q), both triangles.
    fn mass_matrix(&self, q: &SVector<f64, Q>, mass: &mut impl MatrixSink);
    /// A factor of M(q); `None` if M is not positive definite there.
    fn factor_mass(&self, q: &SVector<f64, Q>) -> Option<Self::Mass>;
    /// x ← M⁻¹ x.
    fn solve_mass(&self, mass: &Self::Mass, x: &mut SVector<f64, N>);
    /// p = M(q) v.
    fn momentum(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, p: &mut SVector<f64, N>);
    /// Christoffel affinities of the first kind, Γ_ijk = ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i), and the structure
    /// constants of the rotations (ω × Jω), so that d(M v)/dt − ∂T/∂q = M v̇ + Γ_ijk v_j v_k.
    ///
    /// Straight-line code if they take at most 2500 operations. Otherwise they are computed from ∂p/∂q and M at run
    /// time. This allocates, so use it for checks, not in steps.
    fn affinities(&self, q: &SVector<f64, Q>, gamma: &mut impl TensorSink);
    /// T(q, v), J.
    fn kinetic_energy(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64;
}
