//! Applied forces, F, and their tangents.

use super::{Inertia, NamedValues};
use crate::MatrixSink;
use crate::sink::Discard;
use nalgebra::SVector;

/// The forces of a mechanism with Q coordinates and N velocities.
pub trait Loads<const Q: usize, const N: usize>: Inertia<Q, N> {
    /// The `Input`s as fields.
    type Inputs: NamedValues;

    /// The current values of the `Input`s, in the order of [`Model::inputs`](crate::Model::inputs).
    fn inputs(&self) -> &[f64];
    /// The current values of the `Input`s, to be set.
    fn inputs_mut(&mut self) -> &mut [f64];
    /// Applied generalized forces f(q, v, t): gravity, springs, dampers, forces, torques.
    fn applied_forces(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f: &mut SVector<f64, N>,
    );
    /// F = f + ∂T/∂q + (Jω) × ω of the rotations, the right-hand side of ṗ = F + Aᵀλ.
    fn forces(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f: &mut SVector<f64, N>);
    /// ∂f/∂q and ∂f/∂v of the applied forces.
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    );
    /// ∂F/∂q, ∂F/∂v and ∂p/∂q (the last is zero if M is constant).
    fn force_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    );
    /// F − ṗ|_v, M v̇ without rows, where ṗ|_v = (∂p/∂q) v is the rate of p at constant v: generated if M varies.
    #[inline(always)]
    fn free_forces(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f: &mut SVector<f64, N>,
    ) {
        self.forces(t, q, v, f);
        let mut change = Product { v, result: f };
        self.force_tangents(t, q, v, &mut Discard, &mut Discard, &mut change);
    }
    /// p and F together: generated if M varies, so that common subexpressions are computed once.
    #[inline(always)]
    fn balance(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        p: &mut SVector<f64, N>,
        f: &mut SVector<f64, N>,
    ) {
        self.momentum(q, v, p);
        self.forces(t, q, v, f);
    }
    /// M, ∂F/∂q, ∂F/∂v and ∂p/∂q together: generated if M varies.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn balance_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        mass: &mut impl MatrixSink,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    ) {
        self.mass_matrix(q, mass);
        self.force_tangents(t, q, v, f_q, f_v, p_q);
    }
    /// M⁻¹ f(q, t) of the applied forces, if M is constant and forces do not depend on velocities; otherwise zero and
    /// not used.
    fn acceleration(&self, t: f64, q: &SVector<f64, Q>, acceleration: &mut SVector<f64, N>);
    /// V(q) of gravity and springs, J.
    fn potential_energy(&self, q: &SVector<f64, Q>) -> f64;
    /// Power of the applied forces that have no potential, W.
    fn nonconservative_power(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64;
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
