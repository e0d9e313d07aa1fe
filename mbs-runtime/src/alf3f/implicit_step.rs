//! The multiplier inside the implicit step, for forces that depend on velocities.
//!
//! ```text
//! p(q₁, v_b) − p(q₀, v₀) = h/2 (F₀ + F₁) + ½(A₀ + A₁)ᵀ κ,    q₁ = q₀ ⊕ h/2 (v₀ + v_b)
//! φ(q₁, t₁) = 0 (holonomic),  N₁ v_b + n₁ = 0 (nonholonomic) → κ
//! v₁ = v_b + (M₁ − h/2 ∂F/∂v)⁻¹ A₁ᵀ κ₂,      A₁ v₁ + b₁ = 0 → κ₂
//! ```
//!
//! A kick would move one side of a stiff damper only; the metric M − h/2 ∂F/∂v lets its far side follow. The springs'
//! −h²/4 ∂F/∂q is part of Newton's J but not of this metric: with it the error grows with the damping. Near a singular pose ½(A₀ + A₁) loses a direction that A₁ still has; that step is left to the kicks.

use super::kicks::{STAGNATED, not_converged, residual_of};
use super::step_context::StepContext;
use super::{ConstraintGeometry, Fault};
use crate::System;
use crate::flow::{Implicit, transport, trapezoid};
use crate::linear::{Pivoted, ProjectionLu, RowMatrix, accumulate, dot, vector};
use nalgebra::SVector;

/// Corrections of the velocities below this fraction of them end the iteration.
const CONVERGED: f64 = 1e-14;
/// Corrections below this fraction of the velocities end it when they no longer shrink.
const STILL: f64 = 1e-10;
/// Below this ratio of the smallest pivots of A₁J⁻¹½(A₀ + A₁)ᵀ and A₁J⁻¹A₁ᵀ the mean direction counts as lost.
const LOST: f64 = 0.3;

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
        let holonomic = S::STRUCTURE.holonomic_rows;
        let StepContext {
            system,
            state,
            max_iterations,
            start,
            end,
            work,
            scale,
            yardstick,
            counters,
            ..
        } = context;
        let (q0, v0, t1) = (state.positions, state.velocities, state.time + h);
        let mut weights = scale.weights;
        // A rate that moves no position is none.
        let floor = yardstick.imperceptible(&q0, h) / scale.tolerance;
        let speed = yardstick.measure(&v0).max(floor);
        for weight in &mut weights.as_mut_slice()[holonomic..] {
            *weight /= speed * speed;
        }

        self.solver.begin(t1, h);
        self.solver.impulse(system, state.time, &q0, &v0);
        let known = self.solver.known;
        let mut kappa = state.expected_impulse(h);
        let mut vb = v0;
        let (mut last, mut last_change) = (f64::NAN, f64::NAN);
        let mut iterations = 0;
        let q = loop {
            let q = trapezoid(system, &q0, &v0, &vb, h);
            system.constraints(t1, &q, &mut work.phi, &mut end.a, &mut end.b);
            let mut defect = work.phi;
            for i in holonomic..R {
                defect[i] = dot(&end.a[i], &vb) + end.b[i];
            }
            for i in 0..R {
                self.mean[i] = vector(|j| 0.5 * (start.a[i][j] + end.a[i][j]));
            }
            self.solver.known = known;
            accumulate(&mut self.solver.known, &self.mean, &kappa);
            let mut change = self.solver.defect(system, &q, &vb);

            let residual = residual_of(&defect, &weights);
            let slow = !(residual < 1e-2 * last || residual <= 1.0);
            if !last_change.is_finite() || slow || self.solver.is_stale() {
                self.solver.refresh(system, &q, &v0, &vb)?;
                let turn = vector(|i| 0.5 * h * (v0[i] + vb[i]));
                if !self.factor(system, end, &turn, &mut work.projection) {
                    return Ok(Outcome::Lost);
                }
                counters.regularised += u64::from(work.projection.regularised);
            }
            self.solver.jacobian.solve(&mut change);
            let mut moved = [change];
            if !S::ROTATIONS.is_empty() {
                let turn = vector(|i| 0.5 * h * (v0[i] + vb[i]));
                transport::<S, Q, N, R>(&turn, &mut moved);
            }
            let mut multiplier: SVector<f64, R> = vector(|i| {
                if i < holonomic {
                    -2.0 / h * defect[i] - dot(&end.a[i], &moved[0])
                } else {
                    -defect[i] - dot(&end.a[i], &change)
                }
            });
            work.projection.solve(&mut multiplier);
            accumulate(&mut change, &self.along_mean, &multiplier);
            for i in 0..N {
                vb[i] += change[i];
            }
            for i in 0..R {
                kappa[i] += multiplier[i];
            }

            let size = yardstick.measure(&change);
            let speed = yardstick.measure(&vb);
            let enough = (CONVERGED * speed).max(yardstick.imperceptible(&q, h));
            // The next correction, at the rate of this one.
            let next = size * (size / last_change).min(1.0);
            let settled = next <= enough || (size >= 0.5 * last_change && size <= STILL * speed);
            if settled && (residual <= 1.0 || (residual > 0.5 * last && residual < STAGNATED)) {
                break q;
            }
            iterations += 1;
            if iterations > *max_iterations || !size.is_finite() || !residual.is_finite() {
                return Err(if R > 0 && residual > 1.0 {
                    not_converged(&defect, &weights, iterations)
                } else {
                    Fault::Flow {
                        residual: size,
                        iterations,
                    }
                });
            }
            if size > 0.1 * last_change {
                self.solver.invalidate();
            }
            (last, last_change) = (residual, size);
        };
        counters.iterations += iterations as u64;
        work.impulse[0] = kappa;

        end.metric(system, t1, &q)?;
        work.impulse[1] = self.project(system, end, &mut vb)?;
        let weak = context.work.projection.regularised || self.end_projection.regularised;
        context.commit(t1, h, q, vb, weak)?;
        Ok(Outcome::Done)
    }

    /// Factors A₁J⁻¹½(A₀ + A₁)ᵀ; false where it has lost a direction that A₁J⁻¹A₁ᵀ has.
    fn factor<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        turn: &SVector<f64, N>,
        projection: &mut ProjectionLu<R>,
    ) -> bool {
        let lengths = self.factor_end(system, end, Along::Position);
        for i in 0..R {
            self.along_mean[i] = self.mean[i];
            self.solver.jacobian.solve(&mut self.along_mean[i]);
        }
        system.delassus(&end.a, &self.along_mean, &mut self.metric);
        if !S::ROTATIONS.is_empty() {
            self.turn_holonomic(system, end, turn);
        }
        projection.factor(&self.metric, &lengths, None);
        self.end_projection.regularised
            || projection.smallest_pivot(&lengths)
                >= LOST * self.end_projection.smallest_pivot(&lengths)
    }

    /// Makes A₁TJ⁻¹½(A₀ + A₁)ᵀ of the holonomic rows: velocities reach positions through the tangent of ⊕.
    fn turn_holonomic<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        turn: &SVector<f64, N>,
    ) {
        let plain = *self.metric;
        *self.along_end = *self.along_mean;
        transport::<S, Q, N, R>(turn, self.along_end.rows_mut());
        system.delassus(&end.a, &self.along_end, &mut self.metric);
        for i in S::STRUCTURE.holonomic_rows..R {
            self.metric[i] = plain.column(i).into_owned();
        }
    }

    /// Factors A₁J⁻¹A₁ᵀ, J taken as `along` tells, and returns its diagonal.
    fn factor_end<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        along: Along,
    ) -> SVector<f64, R> {
        let metric = match along {
            Along::Position => &self.solver.jacobian,
            Along::Velocity => &self.velocity_metric,
        };
        for i in 0..R {
            self.along_end[i] = end.a[i];
            metric.solve(&mut self.along_end[i]);
        }
        system.delassus(&end.a, &self.along_end, &mut self.metric);
        let lengths = vector(|i| self.metric[i][i].abs());
        self.end_projection.factor(&self.metric, &lengths, None);
        lengths
    }

    /// v₁ from v_b; returns κ₂.
    fn project<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        end: &ConstraintGeometry<S, Q, N, R>,
        v: &mut SVector<f64, N>,
    ) -> Result<SVector<f64, R>, Fault> {
        self.solver.velocity_metric(&mut self.velocity_metric)?;
        self.factor_end(system, end, Along::Velocity);
        let mut total = SVector::zeros();
        let passes = if self.end_projection.regularised {
            4
        } else {
            1
        };
        for _ in 0..passes {
            let mut multiplier = end.velocity_rows(system, v).map(|rate| -rate);
            self.end_projection.solve(&mut multiplier);
            accumulate(v, &self.along_end, &multiplier);
            for i in 0..R {
                total[i] += multiplier[i];
            }
        }
        Ok(total)
    }
}
