//! Constraint rows, and the products with them that each step needs.

use super::{Elimination, Inertia};
use crate::MatrixSink;
use nalgebra::{SMatrix, SVector};

/// The R constraint rows of a mechanism with Q coordinates and N velocities.
pub trait Constraints<const Q: usize, const N: usize, const R: usize>: Inertia<Q, N> {
    /// Sparse elimination, for large mechanisms.
    const ELIMINATION: Option<&'static Elimination<N, R>> = None;

    /// φ(q, t), the holonomic rows only.
    fn holonomic(&self, t: f64, q: &SVector<f64, Q>, phi: &mut SVector<f64, R>);
    /// φ (holonomic rows only), A and b.
    fn constraints(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        phi: &mut SVector<f64, R>,
        a: &mut impl MatrixSink,
        b: &mut SVector<f64, R>,
    );
    /// The same with A in the array of K, if there is an [`Self::ELIMINATION`].
    #[inline(always)]
    fn sparse_constraints(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        phi: &mut SVector<f64, R>,
        k: &mut [f64],
        b: &mut SVector<f64, R>,
    ) {
        let _ = (t, q, phi, k, b);
    }
    /// M in the array of K, if there is an [`Self::ELIMINATION`] and M varies.
    #[inline(always)]
    fn sparse_mass(&self, q: &SVector<f64, Q>, k: &mut [f64]) {
        let _ = (q, k);
    }
    /// Ȧ along v, and γ = d(A v + b)/dt at constant v: the rows at acceleration level are A v̇ + γ = 0.
    fn constraint_rates(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        a_rate: &mut impl MatrixSink,
        gamma: &mut SVector<f64, R>,
    );
    /// Row by row w = M⁻¹ a; `a` has the zero pattern of A.
    fn solve_mass_rows(
        &self,
        mass: &Self::Mass,
        a: &SMatrix<f64, N, R>,
        w: &mut SMatrix<f64, N, R>,
    );
    /// `delassus[i][j]` = a_i · w_j, where `a` has the zero pattern of A.
    fn delassus(
        &self,
        a: &SMatrix<f64, N, R>,
        w: &SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    );
    /// `w` = M⁻¹ a row by row and `delassus` = A M⁻¹ Aᵀ, where `a` is A(q, t) and `mass` the factor of M(q). Generated
    /// if one fused function is cheaper than the two that it replaces.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn metric(
        &self,
        mass: &Self::Mass,
        t: f64,
        q: &SVector<f64, Q>,
        a: &SMatrix<f64, N, R>,
        w: &mut SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    ) {
        let _ = (t, q);
        self.solve_mass_rows(mass, a, w);
        self.delassus(a, w, delassus);
    }
    /// A v, where `a` has the zero pattern of A.
    #[inline(always)]
    fn row_rates(&self, a: &SMatrix<f64, N, R>, v: &SVector<f64, N>, rates: &mut SVector<f64, R>) {
        let [rates] = &mut rates.data.0;
        for (rate, row) in rates.iter_mut().zip(crate::linear::rows(a)) {
            *rate = crate::linear::dot(row, v);
        }
    }
}
