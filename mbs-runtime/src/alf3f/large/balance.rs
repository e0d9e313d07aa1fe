//! The momentum balance and the rows of a step, corrected until both hold.

use super::step::{SparseStep, rates};
use crate::System;
use crate::alf3f::closing::{Closing, not_converged, residual_of};
use crate::alf3f::corrections::Corrections;
use crate::alf3f::step_context::StepContext;
use crate::fault::Fault;
use crate::flow::trapezoid;
use crate::linear::{entries_mut, vector, zeros};
use crate::state::COST;
use nalgebra::SVector;

/// What corrections may leave of v, as a fraction of ∇³v: the error of a step is h³v‴/12, and this about a ten-thousandth of
/// it. Down to round-off a step of 20 × 20 bodies on bushings takes 2.9 corrections, with a tenth of this 2.2.
const FRACTION: f64 = 1e-5;

/// The momentum balance of a step with its rows, as functions of v_b and κ.
pub(super) struct Balance<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    step: &'a mut SparseStep<Q, N, R>,
    context: &'a mut StepContext<S, Q, N, R>,
    /// p₀ + h/2 F₀.
    known: SVector<f64, N>,
    weights: SVector<f64, R>,
    t1: f64,
    h: f64,
    q: SVector<f64, Q>,
    vb: SVector<f64, N>,
    kappa: SVector<f64, R>,
    /// φ, and what is left of N v + n.
    defect: SVector<f64, R>,
    /// What is missing of the momentum balance.
    change: SVector<f64, N>,
    corrections: Corrections,
    /// The first correction takes back what multipliers have along combinations without force. No row answers to it: its
    /// round-off would grow from step to step by the extrapolation of the multipliers.
    is_first: bool,
}

impl<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    Balance<'a, S, Q, N, R>
{
    /// For the step of h that ends at t₁, from a guess of v_b. `step` has p and F at the beginning.
    pub(super) fn new(
        step: &'a mut SparseStep<Q, N, R>,
        context: &'a mut StepContext<S, Q, N, R>,
        weights: SVector<f64, R>,
        (t1, h): (f64, f64),
        guess: SVector<f64, N>,
    ) -> Self {
        let (momentum, force) = (&step.momentum, &step.force);
        let state = &context.state;
        let differences = state.differences.as_ref();
        let enough = FRACTION * differences.map_or(0.0, |known| known.third);
        Balance {
            known: vector(|i| momentum[i] + 0.5 * h * force[i]),
            kappa: state.expected_impulse(h),
            q: state.positions,
            vb: guess,
            step,
            context,
            weights,
            t1,
            h,
            defect: zeros(),
            change: zeros(),
            corrections: Corrections::down_to(enough),
            is_first: true,
        }
    }

    /// q₁, v_b and κ.
    pub(super) fn end(self) -> (SVector<f64, Q>, SVector<f64, N>, SVector<f64, R>) {
        (self.q, self.vb, self.kappa)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Closing
    for Balance<'_, S, Q, N, R>
{
    const PATIENCE: i32 = COST as i32;
    const VELOCITIES: bool = true;
    /// The first correction is much larger than the others: what it leaves of the rows is not linear in it.
    const TELLING: usize = 2;

    fn round_off(&self) -> f64 {
        self.context.round_off_of_rows(false, &self.q)
    }

    fn residual(&mut self) -> Result<f64, Fault> {
        let StepContext {
            system,
            state,
            end,
            work,
            ..
        } = &mut *self.context;
        let SparseStep {
            tangents,
            force,
            momentum,
            ..
        } = &mut *self.step;
        let (q0, v0) = (&state.positions, &state.velocities);
        self.q = trapezoid(system, q0, v0, &self.vb, self.h);
        let a = &mut tangents.end.sink();
        system.constraints(self.t1, &self.q, &mut work.phi, a, &mut end.b);
        self.defect = work.phi;
        if S::STRUCTURE.holonomic_rows < R {
            let rates = rates(&tangents.end, &self.vb, &end.b);
            let holonomic = S::STRUCTURE.holonomic_rows;
            self.defect.as_mut_slice()[holonomic..].copy_from_slice(&rates.as_slice()[holonomic..]);
        }
        system.balance(self.t1, &self.q, &self.vb, momentum, force);
        self.change = vector(|i| self.known[i] - momentum[i] + 0.5 * self.h * force[i]);
        let ends = tangents.start.iter().zip(&tangents.end.values);
        let change = entries_mut(&mut self.change);
        for ((row, column, before), after) in ends {
            change[column] += 0.5 * (before + after) * self.kappa[row];
        }
        Ok(residual_of(&self.defect, &self.weights))
    }

    fn factor(&mut self) -> Result<bool, Fault> {
        let v0 = &self.context.state.velocities;
        let turn = vector(|i| 0.5 * self.h * (v0[i] + self.vb[i]));
        let SparseStep {
            tangents,
            matrices,
            origin,
            turns,
            current,
            ..
        } = &mut *self.step;
        tangents.evaluate(&self.context.system, self.t1, (&self.q, &self.vb));
        origin.step = 0.0;
        turns.set(&self.q, &self.q);
        *current = matrices.factor_positions::<S, Q, N, R>(tangents, &turn, self.h);
        Ok(*current)
    }

    fn solve(&mut self) -> bool {
        let SparseStep {
            matrices,
            turns,
            x,
            current,
            ..
        } = &mut *self.step;
        let (velocities, multipliers) = x.split_at_mut(N);
        velocities.copy_from_slice(self.change.as_slice());
        for (i, x) in multipliers.iter_mut().enumerate() {
            *x = match i < S::STRUCTURE.holonomic_rows {
                true => -2.0 / self.h * self.defect[i],
                false => -self.defect[i],
            };
            if self.is_first {
                *x -= matrices.positions.proximal(i) * self.kappa[i];
            }
        }
        self.is_first = false;
        turns.undo(x);
        if !matrices.positions.lu.solve(x) {
            // The next residual is not finite, either, which ends the iteration.
            x.fill(f64::NAN);
        }
        turns.redo(x);
        let change = SVector::from_column_slice(&x[..N]);
        self.vb += change;
        self.kappa += SVector::<f64, R>::from_column_slice(&x[N..]);
        let end = (&self.q, &self.vb);
        let (yardstick, states) = (&self.context.yardstick, self.context.system.states());
        let verdict = self
            .corrections
            .add(&change, end, self.h, yardstick, states);
        *current &= !verdict.is_slow_for(Self::PATIENCE);
        verdict.is_end(N + R)
    }

    fn is_settled(&self) -> bool {
        self.corrections.settled
    }

    fn is_stale(&self) -> bool {
        !self.step.current
    }

    fn fault(&self, iterations: usize) -> Fault {
        if R > 0 && !(residual_of(&self.defect, &self.weights) <= 1.0) {
            not_converged(&self.defect, &self.weights, iterations)
        } else {
            Fault::Flow {
                residual: self.corrections.size,
                iterations,
            }
        }
    }
}
