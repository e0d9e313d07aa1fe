//! The constraint geometry and the acceleration at one instant: the end of a step is the start of the next one.

use crate::System;
use crate::fault::Fault;
use crate::linear::{RowMatrix, add, dot, vector};
use crate::memory::Box;
use nalgebra::SVector;

/// A, b, W = M⁻¹Aᵀ, S = A M⁻¹ Aᵀ and M⁻¹f at one instant.
#[derive(Clone)]
pub(crate) struct ConstraintGeometry<
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
> {
    pub(crate) mass: S::Mass,
    /// A, row by row.
    pub(crate) a: RowMatrix<N, R>,
    /// M⁻¹ Aᵀ, row by row.
    pub(crate) w: RowMatrix<N, R>,
    pub(crate) b: SVector<f64, R>,
    /// A M⁻¹ Aᵀ; its diagonal holds 1/m̄ of equation (18).
    pub(crate) delassus: RowMatrix<R, R>,
    /// M⁻¹ f where it is needed (leapfrog).
    pub(crate) acceleration: SVector<f64, N>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    ConstraintGeometry<S, Q, N, R>
{
    /// The metric at q, with all arrays clear.
    ///
    /// Allocated on the heap, in a separate function, because large systems would overflow small stacks.
    #[inline(never)]
    pub(crate) fn new(system: &S, q: &SVector<f64, Q>) -> Result<Box<Self>, Fault> {
        let mass = system.factor_mass(q).ok_or(Fault::Mass)?;
        Ok(Box::new(ConstraintGeometry {
            mass,
            a: RowMatrix::zeros(),
            w: RowMatrix::zeros(),
            b: SVector::zeros(),
            delassus: RowMatrix::zeros(),
            acceleration: SVector::zeros(),
        }))
    }

    /// Everything at the declared guess.
    pub(crate) fn at_guess(system: &S) -> Result<Box<Self>, Fault> {
        let (q, _) = system.guess();
        let mut geometry = ConstraintGeometry::new(system, &q)?;
        geometry.evaluate(system, 0.0, &q, &mut SVector::zeros())?;
        Ok(geometry)
    }

    /// M, W and S at q, for the A that is there.
    #[inline(always)]
    pub(crate) fn metric(&mut self, system: &S, t: f64, q: &SVector<f64, Q>) -> Result<(), Fault> {
        if !S::STRUCTURE.constant_mass {
            self.mass = system.factor_mass(q).ok_or(Fault::Mass)?;
        }
        system.metric(&self.mass, t, q, &self.a, &mut self.w, &mut self.delassus);
        Ok(())
    }

    /// Everything at (t, q); φ goes to `phi`.
    pub(crate) fn evaluate(
        &mut self,
        system: &S,
        t: f64,
        q: &SVector<f64, Q>,
        phi: &mut SVector<f64, R>,
    ) -> Result<(), Fault> {
        system.constraints(t, q, phi, self.a.entries_mut(), &mut self.b);
        self.metric(system, t, q)?;
        system.acceleration(t, q, &mut self.acceleration);
        Ok(())
    }

    /// 1/m̄ of each row.
    #[inline(always)]
    pub(crate) fn lengths_squared(&self) -> SVector<f64, R> {
        let delassus = &self.delassus.data.0;
        vector(|i| delassus[i][i])
    }

    /// A v + b.
    #[inline(always)]
    pub(crate) fn velocity_rows(&self, system: &S, v: &SVector<f64, N>) -> SVector<f64, R> {
        let mut rates = crate::linear::zeros();
        system.row_rates(&self.a, v, &mut rates);
        add(&mut rates, &self.b);
        rates
    }

    /// Row i of A v + b.
    #[inline(always)]
    pub(crate) fn velocity_row(&self, i: usize, v: &SVector<f64, N>) -> f64 {
        dot(&self.a[i], v) + self.b[i]
    }

    /// S of the holonomic rows, with unit rows in place of the others.
    pub(crate) fn holonomic_delassus(&self) -> RowMatrix<R, R> {
        let mut delassus = self.delassus.clone();
        let rows = delassus.entries_mut();
        for i in S::STRUCTURE.holonomic_rows..R {
            for j in 0..R {
                rows[i][j] = 0.0;
                rows[j][i] = 0.0;
            }
            rows[i][i] = 1.0;
        }
        delassus
    }
}
