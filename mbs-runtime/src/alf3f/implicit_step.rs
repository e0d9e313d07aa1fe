//! The multiplier inside the implicit step, for forces that depend on velocities.
//!
//! ```text
//! p(q₁, v_b) − p(q₀, v₀) = h/2 (F₀ + F₁) + ½(A₀ + A₁)ᵀ κ,    q₁ = q₀ ⊕ h/2 (v₀ + v_b)
//! φ(q₁, t₁) = 0 (holonomic),  N₁ v_b + n₁ = 0 (nonholonomic) → κ
//! v₁ = v_b + (M₁ − h/2 ∂F/∂v)⁻¹ A₁ᵀ κ₂,      A₁ v₁ + b₁ = 0 → κ₂
//! ```
//!
//! A kick changes the velocity of one side of a stiff damper only; with the metric M − h/2 ∂F/∂v the other side moves,
//! too. The term −h²/4 ∂F/∂q of springs is part of Newton's J, but not of this metric: with it the error would grow
//! with the damping. Near a singular pose ½(A₀ + A₁) loses a direction that A₁ still has; such a step is taken with
//! kicks.

use super::closing::{self, Closing, Limits, Refining, refine};
use super::closing::{not_converged, residual_of};
use super::corrections::Corrections;
use super::step_context::{PROMPT, REFINEMENTS, StepContext};
use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::flow::{Implicit, transport, trapezoid};
use crate::linear::{Pivoted, ProjectionLu, RowMatrix, accumulate, dot, negative, vector};
use crate::memory::Box;
use crate::singular::MEAN_LOST;
use nalgebra::SVector;

/// How a step ended.
pub(super) enum Outcome {
    Done,
    /// The mean of A₀ and A₁ has lost a direction: take this step with kicks.
    Lost,
}

/// The two metrics of the step.
enum Along {
    /// J of Newton's method.
    Position,
    /// M − h/2 ∂F/∂v.
    Velocity,
}

#[derive(Clone)]
pub(super) struct ImplicitStep<const Q: usize, const N: usize, const R: usize> {
    solver: Implicit<N>,
    /// ½(A₀ + A₁), and J⁻¹ times its rows.
    mean: RowMatrix<N, R>,
    along_mean: RowMatrix<N, R>,
    /// J⁻¹A₁ᵀ, row by row.
    along_end: RowMatrix<N, R>,
    metric: RowMatrix<R, R>,
    end_projection: ProjectionLu<R>,
    velocity_metric: Pivoted<N>,
}

impl<const Q: usize, const N: usize, const R: usize> ImplicitStep<Q, N, R> {
    #[inline(never)]
    pub(super) fn new() -> Box<Self> {
        Box::new(ImplicitStep {
            solver: Implicit::new(),
            mean: RowMatrix::zeros(),
            along_mean: RowMatrix::zeros(),
            along_end: RowMatrix::zeros(),
            metric: RowMatrix::zeros(),
            end_projection: ProjectionLu::new(),
            velocity_metric: Pivoted::new(),
        })
    }

    pub(super) fn step<S: System<Q, N, R>>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
    ) -> Result<Outcome, Fault> {
        context.settle_redundant();
        let (q0, v0, t1) = (
            context.state.positions,
            context.state.velocities,
            context.end_time,
        );
        let StepContext {
            system,
            state,
            scale,
            yardstick,
            ..
        } = &*context;
        let mut weights = scale.weights;
        // A rate that moves no position is none.
        let floor = yardstick.imperceptible(&q0, h) / scale.tolerance;
        let speed = yardstick.measure(&v0).max(floor);
        for weight in &mut weights.as_mut_slice()[S::STRUCTURE.holonomic_rows..] {
            *weight /= speed * speed;
        }
        let limits = Limits {
            most: context.max_iterations,
            fixed: None,
        };
        self.solver.begin(t1, h);
        self.solver.impulse(system, state.time, &q0, &v0);
        let mut rows = Balance {
            known: self.solver.known,
            kappa: state.expected_impulse(h),
            step: &mut *self,
            context: &mut *context,
            weights,
            t1,
            h,
            q: q0,
            vb: v0,
            defect: crate::linear::zeros(),
            change: crate::linear::zeros(),
            corrections: Corrections::none(),
        };
        let closed = closing::close(&mut rows, limits, false);
        let Balance {
            q, mut vb, kappa, ..
        } = rows;
        let closed = match closed {
            // The proximal solve follows multipliers of nearly dependent rows slowly; kicks do not need them to digits.
            Err(Fault::Flow { .. } | Fault::Row { .. }) if context.work.projection.regularised => {
                return Ok(Outcome::Lost);
            }
            closed => closed?,
        };
        let Some(closed) = closed else {
            return Ok(Outcome::Lost);
        };
        let StepContext {
            system,
            end,
            work,
            scale,
            counters,
            ..
        } = &mut *context;
        counters.iterations += closed.iterations as u64;
        work.impulse[0] = kappa;

        end.metric(system, t1, &q)?;
        let before = vb;
        let skipped = work.delassus.skipped();
        work.impulse[1] = self.project(system, end, &mut vb, &scale.weights, skipped)?;
        if closed.iterations > PROMPT {
            context.check_way(0.5 * h, &(vb - before))?;
        }
        let weak = context.work.projection.regularised || self.end_projection.regularised;
        context.commit(t1, h, q, vb, weak)?;
        context.share_impulse();
        Ok(Outcome::Done)
    }

    /// Factors A₁J⁻¹½(A₀ + A₁)ᵀ; its smallest pivot, relative to `usual` of a row that is shorter, or `None` where it has lost a
    /// direction that A₁J⁻¹A₁ᵀ has.
    fn factor<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        turn: &SVector<f64, N>,
        (projection, usual): (&mut ProjectionLu<R>, &SVector<f64, R>),
        skipped: Option<&[bool; R]>,
    ) -> Option<f64> {
        let lengths = self.factor_end(system, end, Along::Position, skipped);
        self.along_mean.overwrite(&self.mean);
        self.solver.jacobian.solve_rows(&mut self.along_mean);
        system.delassus(&end.a, &self.along_mean, &mut self.metric);
        if !S::ROTATIONS.is_empty() {
            self.turn_holonomic(system, end, turn);
        }
        projection.factor(&self.metric, &lengths, skipped);
        let is_kept = self.end_projection.regularised
            || projection.smallest_pivot(&lengths)
                >= MEAN_LOST * self.end_projection.smallest_pivot(&lengths);
        is_kept.then(|| projection.smallest_pivot(&lengths.sup(usual)))
    }

    /// Computes A₁TJ⁻¹½(A₀ + A₁)ᵀ for the holonomic rows, with T the tangent of ⊕.
    fn turn_holonomic<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        turn: &SVector<f64, N>,
    ) {
        let plain = *self.metric;
        self.along_end.overwrite(&self.along_mean);
        transport::<S, Q, N, R>(turn, self.along_end.rows_mut());
        system.delassus(&end.a, &self.along_end, &mut self.metric);
        for i in S::STRUCTURE.holonomic_rows..R {
            self.metric[i] = plain.column(i).into_owned();
        }
    }

    /// Factors A₁J⁻¹A₁ᵀ, with J chosen by `along`; returns the diagonal.
    fn factor_end<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        along: Along,
        skipped: Option<&[bool; R]>,
    ) -> SVector<f64, R> {
        let metric = match along {
            Along::Position => &self.solver.jacobian,
            Along::Velocity => &self.velocity_metric,
        };
        self.along_end.overwrite(&end.a);
        metric.solve_rows(&mut self.along_end);
        system.delassus(&end.a, &self.along_end, &mut self.metric);
        let lengths = vector(|i| self.metric[i][i].abs());
        self.end_projection.factor(&self.metric, &lengths, skipped);
        lengths
    }

    /// v₁ from v_b; returns κ₂.
    fn project<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        v: &mut SVector<f64, N>,
        weights: &SVector<f64, R>,
        skipped: Option<&[bool; R]>,
    ) -> Result<SVector<f64, R>, Fault> {
        self.solver.velocity_metric(&mut self.velocity_metric)?;
        self.factor_end(system, end, Along::Velocity, skipped);
        let passes = match self.end_projection.regularised {
            true => REFINEMENTS,
            false => 1,
        };
        let mut rows = Rates {
            system,
            end,
            step: self,
            v,
            weights,
            total: crate::linear::zeros(),
            rates: crate::linear::zeros(),
        };
        refine(&mut rows, passes, 0.0);
        Ok(rows.total)
    }
}

/// The momentum balance of a step with its rows, as functions of v_b and κ.
struct Balance<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    step: &'a mut ImplicitStep<Q, N, R>,
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

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Balance<'_, S, Q, N, R> {
    fn turn(&self) -> SVector<f64, N> {
        let v0 = &self.context.state.velocities;
        vector(|i| 0.5 * self.h * (v0[i] + self.vb[i]))
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Closing
    for Balance<'_, S, Q, N, R>
{
    const PATIENCE: i32 = 3;
    const VELOCITIES: bool = true;

    fn round_off(&self) -> f64 {
        self.context.round_off_of_rows(false, &self.q)
    }

    #[inline(always)]
    fn residual(&mut self) -> Result<f64, Fault> {
        let StepContext {
            system,
            state,
            start,
            end,
            work,
            ..
        } = &mut *self.context;
        let end = &mut **end;
        self.q = trapezoid(
            system,
            &state.positions,
            &state.velocities,
            &self.vb,
            self.h,
        );
        system.constraints(
            self.t1,
            &self.q,
            &mut work.phi,
            end.a.entries_mut(),
            &mut end.b,
        );
        self.defect = work.phi;
        for i in S::STRUCTURE.holonomic_rows..R {
            self.defect[i] = end.velocity_row(i, &self.vb);
        }
        let ImplicitStep { solver, mean, .. } = &mut *self.step;
        let (before, after) = (&start.a.data.0, &end.a.data.0);
        for (i, row) in mean.entries_mut().iter_mut().enumerate() {
            for j in 0..N {
                row[j] = 0.5 * (before[i][j] + after[i][j]);
            }
        }
        solver.known = self.known;
        accumulate(&mut solver.known, mean, &self.kappa);
        self.change = solver.defect(system, &self.q, &self.vb);
        Ok(residual_of(&self.defect, &self.weights))
    }

    #[inline(always)]
    fn factor(&mut self) -> Result<bool, Fault> {
        let turn = self.turn();
        let StepContext {
            system,
            state,
            end,
            work,
            scale,
            counters,
            ..
        } = &mut *self.context;
        let step = &mut *self.step;
        (step.solver).refresh(system, &self.q, &state.velocities, &self.vb)?;
        let work = &mut **work;
        let skipped = work.delassus.skipped();
        let into = (&mut work.projection, &scale.usual);
        let Some(pivot) = step.factor(system, end, &turn, into, skipped) else {
            return Ok(false);
        };
        self.corrections.amplify(pivot);
        counters.regularised += u64::from(work.projection.regularised);
        Ok(true)
    }

    #[inline(always)]
    fn solve(&mut self) -> bool {
        let mut change = self.change;
        self.step.solver.jacobian.solve(&mut change);
        let mut moved = [change];
        if !S::ROTATIONS.is_empty() {
            transport::<S, Q, N, R>(&self.turn(), &mut moved);
        }
        let StepContext {
            end,
            work,
            yardstick,
            system,
            ..
        } = &mut *self.context;
        let mut multiplier: SVector<f64, R> = vector(|i| {
            if i < S::STRUCTURE.holonomic_rows {
                -2.0 / self.h * self.defect[i] - dot(&end.a[i], &moved[0])
            } else {
                -self.defect[i] - dot(&end.a[i], &change)
            }
        });
        work.projection.solve(&mut multiplier);
        accumulate(&mut change, &self.step.along_mean, &multiplier);
        self.vb += change;
        self.kappa += multiplier;

        let end = (&self.q, &self.vb);
        let verdict = self
            .corrections
            .add(&change, end, self.h, yardstick, system.states());
        if verdict.slow {
            self.step.solver.invalidate();
        }
        verdict.converged
    }

    #[inline(always)]
    fn is_settled(&self) -> bool {
        self.corrections.settled
    }

    fn is_stale(&self) -> bool {
        self.step.solver.is_stale()
    }

    #[inline(always)]
    fn fault(&self, iterations: usize) -> Fault {
        let (defect, weights) = (self.defect, self.weights);
        if R > 0 && !(residual_of(&defect, &weights) <= 1.0) {
            not_converged(&defect, &weights, iterations)
        } else {
            Fault::Flow {
                residual: self.corrections.size,
                iterations,
            }
        }
    }
}

/// A v + b at the end of a step.
struct Rates<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    system: &'a S,
    end: &'a ConstraintGeometry<S, Q, N, R>,
    step: &'a ImplicitStep<Q, N, R>,
    v: &'a mut SVector<f64, N>,
    weights: &'a SVector<f64, R>,
    /// κ₂.
    total: SVector<f64, R>,
    rates: SVector<f64, R>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Refining
    for Rates<'_, S, Q, N, R>
{
    #[inline(always)]
    fn residual(&mut self) -> f64 {
        self.rates = self.end.velocity_rows(self.system, self.v);
        residual_of(&self.rates, self.weights)
    }

    #[inline(always)]
    fn correct(&mut self) {
        let mut multiplier = negative(&self.rates);
        self.step.end_projection.solve(&mut multiplier);
        accumulate(self.v, &self.step.along_end, &multiplier);
        self.total += multiplier;
    }
}
