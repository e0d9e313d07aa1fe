//! The projection of the velocities onto their rows:
//!
//! ```text
//! (M₁ − h/2 F_v) δ = A₁ᵀκ₂,    A₁(v_b + δ) + b₁ = 0
//! ```
//!
//! Factors of an earlier step correct δ and κ₂ until both equations hold. Where they do so slowly, as near a singular
//! pose, the matrix is factored, and its regularised directions are iterated on A v + b alone.

use super::step::{SINGULAR, SparseStep, rates};
use crate::System;
use crate::alf3f::closing::{Refining, refine, residual_of};
use crate::alf3f::corrections::Corrections;
use crate::alf3f::step_context::{REFINEMENTS, StepContext};
use crate::fault::Fault;
use crate::linear::{entries_mut, zeros};
use crate::state::COST;
use nalgebra::SVector;

impl<const Q: usize, const N: usize, const R: usize> SparseStep<Q, N, R> {
    /// v ← v₁ from v_b at the end of a step; returns the number of corrections.
    pub(super) fn project<S: System<Q, N, R>>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        (t1, h): (f64, f64),
        q: &SVector<f64, Q>,
        v: &mut SVector<f64, N>,
    ) -> Result<u64, Fault> {
        if const { S::STRUCTURE.velocity_forces || !S::STRUCTURE.constant_mass } {
            self.tangents.evaluate(&context.system, t1, (q, v));
        }
        if let Some(count) = self.project_with_kept_factors(context, h, q, v) {
            return Ok(count);
        }
        self.origin.step = 0.0;
        if !self.matrices.factor_velocities::<R>(&self.tangents, h) {
            return Err(SINGULAR);
        }
        let enough = context.scale.round_off(context.yardstick.measure(v));
        let mut rows = Rates {
            step: self,
            b: &context.end.b,
            weights: &context.scale.weights,
            v,
            total: &mut context.work.impulse[1],
            rates: zeros(),
            solved: true,
            count: 0,
        };
        refine(&mut rows, REFINEMENTS, enough);
        if rows.solved {
            Ok(rows.count)
        } else {
            Err(SINGULAR)
        }
    }

    /// The same with the factors at hand; `None`, and v as it was, if they correct slowly.
    fn project_with_kept_factors<S: System<Q, N, R>>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
        q: &SVector<f64, Q>,
        v: &mut SVector<f64, N>,
    ) -> Option<u64> {
        let before = *v;
        let mut total: SVector<f64, R> = zeros();
        let mut corrections = Corrections::none();
        for count in 1..=REFINEMENTS as u64 {
            self.write_defect(&(*v - before), &total, h);
            let missing = rates(&self.tangents.end, v, &context.end.b);
            for (x, rate) in self.x[N..].iter_mut().zip(missing.as_slice()) {
                *x = -rate;
            }
            let change = self.solve_velocities()?;
            *v += change;
            total += SVector::<f64, R>::from_column_slice(&self.x[N..]);
            let states = context.system.states();
            let verdict = corrections.add(&change, (q, v), h, &context.yardstick, states);
            if verdict.is_end(N + R) {
                context.work.impulse[1] = total;
                return Some(count);
            }
            if verdict.is_slow_for(COST as i32) {
                break;
            }
        }
        *v = before;
        None
    }

    /// x ← A₁ᵀκ₂ − (M₁ − h/2 F_v) δ.
    fn write_defect(&mut self, delta: &SVector<f64, N>, kappa: &SVector<f64, R>, h: f64) {
        let mut defect: SVector<f64, N> = zeros();
        let x = entries_mut(&mut defect);
        for (row, column, a) in self.tangents.end.iter() {
            x[column] += a * kappa[row];
        }
        for (row, column, m) in self.tangents.mass.iter() {
            x[row] -= m * delta[column];
        }
        for (row, column, f) in self.tangents.f_v.iter() {
            x[row] += 0.5 * h * f * delta[column];
        }
        self.x[..N].copy_from_slice(defect.as_slice());
    }

    /// x ← the correction for the right-hand side x; returns that of the velocities.
    fn solve_velocities(&mut self) -> Option<SVector<f64, N>> {
        let saddle = self.matrices.velocities.as_mut()?;
        let solved = saddle.lu.solve(&mut self.x);
        solved.then(|| SVector::from_column_slice(&self.x[..N]))
    }
}

/// A v + b at the end of a step.
struct Rates<'a, const Q: usize, const N: usize, const R: usize> {
    step: &'a mut SparseStep<Q, N, R>,
    b: &'a SVector<f64, R>,
    weights: &'a SVector<f64, R>,
    v: &'a mut SVector<f64, N>,
    /// κ₂.
    total: &'a mut SVector<f64, R>,
    rates: SVector<f64, R>,
    solved: bool,
    count: u64,
}

impl<const Q: usize, const N: usize, const R: usize> Refining for Rates<'_, Q, N, R> {
    fn residual(&mut self) -> f64 {
        self.rates = rates(&self.step.tangents.end, self.v, self.b);
        residual_of(&self.rates, self.weights)
    }

    fn correct(&mut self) {
        self.count += 1;
        self.step.x[..N].fill(0.0);
        for (x, rate) in self.step.x[N..].iter_mut().zip(self.rates.as_slice()) {
            *x = -rate;
        }
        match self.step.solve_velocities() {
            Some(change) => {
                *self.v += change;
                *self.total += SVector::<f64, R>::from_column_slice(&self.step.x[N..]);
            }
            None => self.solved = false,
        }
    }
}
