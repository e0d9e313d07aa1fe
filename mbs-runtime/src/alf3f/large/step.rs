//! The implicit step with sparse factors:
//!
//! ```text
//! p(q₁, v_b) − p(q₀, v₀) = h/2 (F₀ + F₁) + ½(A₀ + A₁)ᵀ κ,    q₁ = q₀ ⊕ h/2 (v₀ + v_b)
//! φ(q₁, t₁) = 0 (holonomic),  N₁ v_b + n₁ = 0 (nonholonomic) → κ
//! v₁ = v_b + (M₁ − h/2 ∂F/∂v)⁻¹ A₁ᵀ κ₂,      A₁ v₁ + b₁ = 0 → κ₂
//! ```
//!
//! Velocities and multipliers are corrected together, by factors of the
//! [saddle matrix](crate::linear::sparse::Saddle). Its regularisation takes the place of the dense step's look for rows
//! that have lost their direction.
//!
//! Factors are made at the beginning of a step and kept for the next ones, as long as they are worth it
//! ([`Renewal`](crate::Renewal)): corrections end at the same residual with any factors. If they converge slowly, the
//! matrix is factored within the step, and the next one makes new factors; if they fail, so does this one.

use super::balance::Balance;
use super::matrices::StepMatrices;
use super::tangents::Tangents;
use super::turns::Turns;
use crate::alf3f::closing::{self, Limits};
use crate::alf3f::step_context::{PROMPT, StepContext};
use crate::fault::Fault;
use crate::flow::trapezoid;
use crate::linear::sparse::Entries;
use crate::linear::{vector, zeros};
use crate::state::{FactorOrigin, Renewal};
use crate::{State, System};
use nalgebra::SVector;

/// The matrix is singular, or not finite: with h → 0 J becomes M, so that a shorter step helps.
pub(super) const SINGULAR: Fault = Fault::Flow {
    residual: f64::INFINITY,
    iterations: 0,
};

/// Matrices and workspace.
#[derive(Clone)]
pub(crate) struct SparseStep<const Q: usize, const N: usize, const R: usize> {
    pub(super) tangents: Tangents,
    pub(super) matrices: StepMatrices,
    /// Where the factors of `matrices` were made.
    pub(super) origin: FactorOrigin<Q, N>,
    pub(super) turns: Turns,
    /// Right-hand side and solution: N velocities, R multipliers.
    pub(super) x: Vec<f64>,
    pub(super) force: SVector<f64, N>,
    pub(super) momentum: SVector<f64, N>,
    /// Whether the factors serve for the present iteration.
    pub(super) current: bool,
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
            origin: FactorOrigin::none(),
            turns: Turns::new::<S, Q, N, R>(),
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
        let before = context.state.velocities;
        let kept = self.take_up(context, h)?;
        let differences = context.state.differences.as_ref();
        let expected = differences.map_or(before, |known| known.predict(&before, h));
        let taken = match self.attempt(context, h, expected) {
            // As the first step of a run.
            Err(_) => {
                self.begin_anew(context, h)?;
                self.attempt(context, h, before).map(|count| (count, false))
            }
            taken => taken.map(|count| (count, kept)),
        };
        let (corrections, kept) = taken?;
        self.keep(&mut context.state, corrections, kept);
        let StepContext {
            state, yardstick, ..
        } = context;
        if let Some(differences) = &mut state.differences {
            let change = state.velocities - before;
            differences.add(&change, h, |x| yardstick.measure(x));
        }
        let Tangents { start, end, .. } = &mut self.tangents;
        std::mem::swap(start, end);
        Ok(())
    }

    /// Provides the factors that the state asks for; whether they are those of an earlier step.
    fn take_up<S: System<Q, N, R>>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
    ) -> Result<bool, Fault> {
        let kept = context.state.factors.as_deref();
        let Some(origin) = kept.filter(|origin| origin.fits(h)) else {
            self.begin_anew(context, h)?;
            return Ok(false);
        };
        if !self.origin.is_same(origin) {
            self.origin.clone_from(origin);
            self.factor(&context.system)?;
            self.refresh(context);
        }
        Ok(true)
    }

    /// New factors for a step from the current instant.
    fn begin_anew<S: System<Q, N, R>>(
        &mut self,
        context: &StepContext<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        let state = &context.state;
        (self.origin.time, self.origin.step) = (state.time, h);
        self.origin.positions = state.positions;
        self.origin.velocities = state.velocities;
        self.factor(&context.system)
    }

    /// Factors both matrices of the step at whose beginning their origin is, with v₀ for v_b.
    fn factor<S: System<Q, N, R>>(&mut self, system: &S) -> Result<(), Fault> {
        let FactorOrigin {
            time,
            step: h,
            positions: q0,
            velocities: v0,
            ..
        } = &self.origin;
        let (h, t1) = (*h, time + h);
        let q1 = trapezoid(system, q0, v0, v0, h);
        let tangents = &mut self.tangents;
        let (mut phi, mut b) = (zeros(), zeros());
        let (start, end) = (&mut tangents.start, &mut tangents.end);
        system.constraints(*time, q0, &mut phi, &mut start.sink(), &mut b);
        system.constraints(t1, &q1, &mut phi, &mut end.sink(), &mut b);
        tangents.evaluate(system, t1, (&q1, v0));
        let turn = vector(|i| h * v0[i]);
        let matrices = &mut self.matrices;
        let factored = matrices.factor_positions::<S, Q, N, R>(tangents, &turn, h)
            && matrices.factor_velocities::<R>(tangents, h);
        if !factored {
            self.origin.step = 0.0;
            return Err(SINGULAR);
        }
        Ok(())
    }

    /// A step with the factors at hand, from a guess of v_b; returns the number of corrections.
    fn attempt<S: System<Q, N, R>>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
        guess: SVector<f64, N>,
    ) -> Result<u64, Fault> {
        let StepContext {
            system,
            state,
            scale,
            yardstick,
            max_iterations,
            end_time: t1,
            ..
        } = &*context;
        let State {
            time,
            positions: q0,
            velocities: v0,
            ..
        } = state;
        let t1 = *t1;
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
        self.current = true;
        self.turns.set(&self.origin.positions, q0);
        let mut rows = Balance::new(self, context, weights, (t1, h), guess);
        let closed = closing::close(&mut rows, limits, true)?;
        let (q, mut vb, kappa) = rows.end();
        let Some(closed) = closed else {
            return Err(SINGULAR);
        };
        context.counters.iterations += closed.iterations as u64;
        context.work.impulse = [kappa, zeros()];
        let mut corrections = closed.iterations as u64 + 1;
        if R > 0 {
            let before = vb;
            corrections += self.project(context, (t1, h), &q, &mut vb)?;
            if closed.iterations > PROMPT {
                context.check_way(0.5 * h, &(vb - before))?;
            }
        }
        context.commit(t1, h, q, vb, false)?;
        context.share_impulse();
        Ok(corrections)
    }

    /// Tells the state which factors the next step begins with. `kept`: they are older than this step.
    fn keep(&mut self, state: &mut State<Q, N, R>, corrections: u64, kept: bool) {
        let Some(factors) = &mut state.factors else {
            return;
        };
        if self.origin.step == 0.0 {
            factors.step = 0.0;
        } else if !kept {
            self.origin.renewal = Renewal::first(corrections);
            factors.as_mut().clone_from(&self.origin);
        } else if factors.renewal.add(corrections) {
            factors.step = 0.0;
        }
    }
}

/// A v + b.
pub(super) fn rates<const N: usize, const R: usize>(
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
