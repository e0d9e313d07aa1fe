//! The implicit step with sparse factors:
//!
//! ```text
//! p(q₁, v_b) − p(q₀, v₀) = h/2 (F₀ + F₁) + ½(A₀ + A₁)ᵀ κ,    q₁ = q₀ ⊕ h/2 (v₀ + v_b)
//! φ(q₁, t₁) = 0 (holonomic),  N₁ v_b + n₁ = 0 (nonholonomic) → κ
//! v₁ = v_b + (M₁ − h/2 ∂F/∂v)⁻¹ A₁ᵀ κ₂,      A₁ v₁ + b₁ = 0 → κ₂
//! ```
//!
//! Velocities and multipliers are corrected together, by one factor of the
//! [saddle matrix](crate::linear::sparse::Saddle). Its regularisation takes the place of the dense step's look for rows
//! that have lost their direction.

use super::matrices::StepMatrices;
use super::tangents::Tangents;
use crate::alf3f::closing::{self, Closing, Limits, Refining, not_converged, refine, residual_of};
use crate::alf3f::corrections::Corrections;
use crate::alf3f::step_context::{PROMPT, REFINEMENTS, StepContext};
use crate::fault::Fault;
use crate::flow::trapezoid;
use crate::linear::sparse::Entries;
use crate::linear::{entries_mut, vector, zeros};
use crate::{State, System};
use nalgebra::SVector;

/// The matrix is singular, or not finite: with h → 0 J becomes M, so that a shorter step helps.
const SINGULAR: Fault = Fault::Flow {
    residual: f64::INFINITY,
    iterations: 0,
};

/// Matrices and workspace.
#[derive(Clone)]
pub(crate) struct SparseStep<const Q: usize, const N: usize, const R: usize> {
    tangents: Tangents,
    matrices: StepMatrices,
    /// Right-hand side and solution: N velocities, R multipliers.
    x: Vec<f64>,
    force: SVector<f64, N>,
    momentum: SVector<f64, N>,
    /// Whether the matrix is factored for the present iteration.
    current: bool,
}

impl<const Q: usize, const N: usize, const R: usize> SparseStep<Q, N, R> {
    /// A workspace; `None` if the pattern of the equations is singular.
    #[inline(never)]
    pub(crate) fn new<S: System<Q, N, R>>(system: &S, state: &State<Q, N, R>) -> Option<Box<Self>> {
        let State {
            time,
            positions,
            velocities,
            ..
        } = state;
        let tangents = Tangents::new(system, *time, (positions, velocities));
        Some(Box::new(SparseStep {
            matrices: StepMatrices::new::<S, Q, N, R>(&tangents)?,
            tangents,
            x: vec![0.0; N + R],
            force: zeros(),
            momentum: zeros(),
            current: false,
        }))
    }

    /// Recomputes what is known of the current instant.
    pub(crate) fn refresh<S: System<Q, N, R>>(&mut self, context: &mut StepContext<S, Q, N, R>) {
        let StepContext {
            system,
            state,
            start,
            work,
            ..
        } = context;
        let a = &mut self.tangents.start.sink();
        system.constraints(state.time, &state.positions, &mut work.phi, a, &mut start.b);
    }

    /// A v + b at the current instant.
    pub(crate) fn rates<S: System<Q, N, R>>(
        &self,
        context: &StepContext<S, Q, N, R>,
    ) -> SVector<f64, R> {
        rates(
            &self.tangents.start,
            &context.state.velocities,
            &context.start.b,
        )
    }

    pub(crate) fn step<S: System<Q, N, R>>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        let StepContext {
            system,
            state,
            scale,
            yardstick,
            max_iterations,
            ..
        } = &*context;
        let State {
            time,
            positions: q0,
            velocities: v0,
            ..
        } = state;
        let t1 = time + h;
        let mut weights = scale.weights;
        // A rate that moves no position is none.
        let floor = yardstick.imperceptible(q0, h) / scale.tolerance;
        let speed = yardstick.measure(v0).max(floor);
        for weight in &mut weights.as_mut_slice()[S::STRUCTURE.holonomic_rows..] {
            *weight /= speed * speed;
        }
        let limits = Limits {
            most: *max_iterations,
            fixed: None,
        };
        system.balance(*time, q0, v0, &mut self.momentum, &mut self.force);
        let (momentum, force) = (&self.momentum, &self.force);
        self.current = false;
        let mut rows = Balance {
            known: vector(|i| momentum[i] + 0.5 * h * force[i]),
            kappa: state.expected_impulse(h),
            q: *q0,
            vb: *v0,
            step: &mut *self,
            context: &mut *context,
            weights,
            t1,
            h,
            defect: zeros(),
            change: zeros(),
            corrections: Corrections::none(),
        };
        let closed = closing::close(&mut rows, limits, false)?;
        let Balance {
            q, mut vb, kappa, ..
        } = rows;
        let Some(closed) = closed else {
            return Err(SINGULAR);
        };
        context.counters.iterations += closed.iterations as u64;
        context.work.impulse = [kappa, zeros()];
        if R > 0 {
            let before = vb;
            if !self.matrices.factor_velocities::<R>(&self.tangents, h) {
                return Err(SINGULAR);
            }
            let mut rows = Rates {
                step: self,
                b: &context.end.b,
                weights: &context.scale.weights,
                v: &mut vb,
                total: &mut context.work.impulse[1],
                rates: zeros(),
                solved: true,
            };
            refine(&mut rows, REFINEMENTS, 0.0);
            if !rows.solved {
                return Err(SINGULAR);
            }
            if closed.iterations > PROMPT {
                context.check_way(0.5 * h, &(vb - before))?;
            }
        }
        context.commit(t1, h, q, vb, false)?;
        let Tangents { start, end, .. } = &mut self.tangents;
        std::mem::swap(start, end);
        Ok(())
    }
}

/// The momentum balance of a step with its rows, as functions of v_b and κ.
struct Balance<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
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
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Closing
    for Balance<'_, S, Q, N, R>
{
    const PATIENCE: i32 = 3;
    const VELOCITIES: bool = true;

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
            current,
            ..
        } = &mut *self.step;
        let Tangents {
            mass,
            f_q,
            f_v,
            p_q,
            ..
        } = &mut *tangents;
        self.context.system.balance_tangents(
            self.t1,
            &self.q,
            &self.vb,
            &mut mass.sink(),
            &mut f_q.sink(),
            &mut f_v.sink(),
            &mut p_q.sink(),
        );
        *current = matrices.factor_positions::<S, Q, N, R>(tangents, &turn, self.h);
        Ok(*current)
    }

    fn solve(&mut self) -> bool {
        let SparseStep {
            matrices,
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
        }
        if !matrices.saddle.lu.solve(x) {
            // The next residual is not finite, either, which ends the iteration.
            x.fill(f64::NAN);
        }
        let change = SVector::from_column_slice(&x[..N]);
        self.vb += change;
        self.kappa += SVector::<f64, R>::from_column_slice(&x[N..]);
        let end = (&self.q, &self.vb);
        let yardstick = &self.context.yardstick;
        let verdict = self
            .corrections
            .add(&change, end, self.h, yardstick, S::STATES);
        *current &= !verdict.slow;
        verdict.converged
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
}

impl<const Q: usize, const N: usize, const R: usize> Refining for Rates<'_, Q, N, R> {
    fn residual(&mut self) -> f64 {
        self.rates = rates(&self.step.tangents.end, self.v, self.b);
        residual_of(&self.rates, self.weights)
    }

    fn correct(&mut self) {
        let x = &mut self.step.x;
        x[..N].fill(0.0);
        for i in 0..R {
            x[N + i] = -self.rates[i];
        }
        self.solved &= self.step.matrices.saddle.lu.solve(x);
        *self.v += SVector::<f64, N>::from_column_slice(&x[..N]);
        *self.total += SVector::<f64, R>::from_column_slice(&x[N..]);
    }
}

/// A v + b.
fn rates<const N: usize, const R: usize>(
    a: &Entries,
    v: &SVector<f64, N>,
    b: &SVector<f64, R>,
) -> SVector<f64, R> {
    let mut rates = *b;
    for (row, column, value) in a.iter() {
        rates[row] += value * v[column];
    }
    rates
}
