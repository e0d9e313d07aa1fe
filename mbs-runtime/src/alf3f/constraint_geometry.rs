//! The constraint geometry and the acceleration at one instant: the end of a step is the start of the next one.

use super::Fault;
use crate::System;
use crate::linear::{Matrix, clear};

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
    pub(crate) a: Matrix<R, N>,
    /// M⁻¹ Aᵀ, row by row.
    pub(crate) w: Matrix<R, N>,
    pub(crate) b: [f64; R],
    /// A M⁻¹ Aᵀ; its diagonal holds 1/m̄ of equation (18).
    pub(crate) delassus: Matrix<R, R>,
    /// M⁻¹ f where it is needed (leapfrog).
    pub(crate) acceleration: [f64; N],
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    ConstraintGeometry<S, Q, N, R>
{
    /// A node with the metric at q and all arrays clear.
    ///
    /// On the heap from the start, and in a frame of its own: large systems are built on small stacks.
    #[inline(never)]
    pub(crate) fn new(system: &S, q: &[f64; Q]) -> Result<Box<Self>, Fault> {
        let mass = system.factor_mass(q).ok_or(Fault::Mass)?;
        Ok(Box::new(ConstraintGeometry {
            mass,
            a: clear(),
            w: clear(),
            b: [0.0; R],
            delassus: clear(),
            acceleration: [0.0; N],
        }))
    }

    /// Everything at the declared guess.
    pub(crate) fn at_guess(system: &S) -> Result<Box<Self>, Fault> {
        let (q, _) = system.guess();
        let mut geometry = ConstraintGeometry::new(system, &q)?;
        geometry.evaluate(system, 0.0, &q, &mut [0.0; R])?;
        Ok(geometry)
    }

    /// M, W and S at q, for the A that is there.
    #[inline(always)]
    pub(crate) fn metric(&mut self, system: &S, t: f64, q: &[f64; Q]) -> Result<(), Fault> {
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
        q: &[f64; Q],
        phi: &mut [f64; R],
    ) -> Result<(), Fault> {
        system.constraints(t, q, phi, &mut *self.a, &mut self.b);
        self.metric(system, t, q)?;
        system.acceleration(t, q, &mut self.acceleration);
        Ok(())
    }

    /// 1/m̄ of each row.
    #[inline(always)]
    pub(crate) fn lengths_squared(&self) -> [f64; R] {
        ::core::array::from_fn(|i| self.delassus[i][i])
    }

    /// A v + b.
    #[inline(always)]
    pub(crate) fn velocity_rows(&self, system: &S, v: &[f64; N]) -> [f64; R] {
        let mut rates = [0.0; R];
        system.row_rates(&self.a, v, &mut rates);
        ::core::array::from_fn(|i| rates[i] + self.b[i])
    }
}
