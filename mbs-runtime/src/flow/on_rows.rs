//! The velocities on the rows that a kick leads to, for the forces of a step between kicks.
//!
//! ```text
//! v₁ = P v_b − W S⁻¹ b,    P = I − W S⁻¹ A,    W = M⁻¹Aᵀ,    S = A W    at (q₁, t₁)
//! ```

use crate::System;
use crate::fault::Fault;
use crate::linear::{DelassusFactor, RowMatrix, accumulate, add, dot, negative, vector};
use crate::memory::Box;
use nalgebra::SVector;

/// A, b, W and S at the end of a step.
#[derive(Clone)]
pub(crate) struct OnRows<const N: usize, const R: usize> {
    a: RowMatrix<N, R>,
    b: SVector<f64, R>,
    w: RowMatrix<N, R>,
    delassus: RowMatrix<R, R>,
    factor: DelassusFactor<R>,
    /// G P.
    projected: RowMatrix<N, N>,
}

impl<const N: usize, const R: usize> OnRows<N, R> {
    /// With a factor that knows the rows which are redundant.
    #[inline(never)]
    pub(super) fn new(factor: &DelassusFactor<R>) -> Box<Self> {
        Box::new(OnRows {
            a: RowMatrix::zeros(),
            b: SVector::zeros(),
            w: RowMatrix::zeros(),
            delassus: RowMatrix::zeros(),
            factor: factor.clone(),
            projected: RowMatrix::zeros(),
        })
    }

    /// Evaluates and factors the rows at (q, t).
    pub(super) fn evaluate<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        system: &S,
        t: f64,
        q: &SVector<f64, Q>,
    ) -> Result<(), Fault> {
        let mut phi = crate::linear::zeros();
        system.constraints(t, q, &mut phi, self.a.entries_mut(), &mut self.b);
        let mass = system.factor_mass(q).ok_or(Fault::Mass)?;
        system.metric(&mass, t, q, &self.a, &mut self.w, &mut self.delassus);
        self.factor.factor(&self.delassus);
        Ok(())
    }

    /// v₁ of v_b.
    pub(super) fn velocities<S: System<Q, N, R>, const Q: usize>(
        &self,
        system: &S,
        vb: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let mut rates = crate::linear::zeros();
        system.row_rates(&self.a, vb, &mut rates);
        add(&mut rates, &self.b);
        let mut multipliers = negative(&rates);
        self.factor.solve(&mut multipliers);
        let mut v = *vb;
        accumulate(&mut v, &self.w, &multipliers);
        v
    }

    /// G P for the gradients G by v₁, which are then those by v_b.
    pub(super) fn project(&mut self, gradients: &RowMatrix<N, N>) -> &RowMatrix<N, N> {
        for i in 0..N {
            let mut row = gradients[i];
            let mut factors = vector(|k| -dot(&self.w[k], &row));
            self.factor.solve(&mut factors);
            accumulate(&mut row, &self.a, &factors);
            self.projected[i] = row;
        }
        &self.projected
    }
}
