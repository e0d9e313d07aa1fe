//! Kick, flow, kick with nonholonomic rows, alone or beside holonomic ones.
//!
//! Nonholonomic rows have ONE multiplier κₙ, acting in both kicks: N₁ v₁ + n₁ = 0 determines it, and the energy
//! behaviour is that of holonomic rows. Newton's method solves for (κ₁, κₙ) together; with P the velocity projection of
//! the holonomic rows its matrix is
//!
//! ```text
//! holonomic row i:     A₁ᵢ · (∂q₁/∂v_a / h) W₀ⱼ
//! nonholonomic row i:  N₁ᵢ P · ((∂v_b/∂v_a) W₀ⱼ + [j nonholonomic] W₁ⱼ)
//! ```

use super::closing::{self, Closing, Limits, Refining, refine};
use super::closing::{not_converged, residual_of};
use super::step_context::{PROMPT, REFINEMENTS, StepContext, Workspace, factor_holonomic};
use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::flow::KickFlow;
use crate::linear::{accumulate, add, dot, negative, vector};
use crate::singular::EXACT;
use nalgebra::SVector;

/// Slower than any motion: 0/0 does not arise where nothing moves.
const AT_REST: f64 = 1e-100;

pub(crate) fn step<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    h: f64,
) -> Result<(), Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    let (t0, t1) = (context.state.time, context.end_time);
    let limits = Limits {
        most: context.max_iterations,
        fixed: None,
    };
    let kappa = context.state.expected_impulse(h);
    let (q, v) = (context.state.positions, context.state.velocities);
    let mut va = v;
    accumulate(&mut va, &context.start.w, &kappa);
    flow.begin(&context.system, [t0, t1], &q, [&v, &va], &context.start, h);
    context.work.projection.regularised = false;
    let mut rows = Rows {
        beside: S::STRUCTURE.holonomic_rows > 0 && context.work.delassus.beside,
        weights: context.scale.weights,
        is_first: true,
        context: &mut *context,
        flow,
        t1,
        h,
        kappa,
        va,
        q,
        v: crate::linear::zeros(),
        defect: crate::linear::zeros(),
    };
    let closed = closing::close(&mut rows, limits, false)?;
    let Rows { kappa, q, v, .. } = rows;
    let iterations = closed.map_or(0, |closed| closed.iterations);
    context.counters.iterations += iterations as u64;
    context.work.impulse[0] = kappa;
    if iterations > PROMPT {
        context.check_kicks(h)?;
    }
    let weak = context.work.projection.regularised
        || (S::STRUCTURE.holonomic_rows > 0 && context.work.delassus.weak);
    context.commit(t1, h, q, v, weak)
}

/// All rows at the end of a step, as functions of κ₁ and κₙ.
struct Rows<'a, S, F, const Q: usize, const N: usize, const R: usize>
where
    S: System<Q, N, R>,
{
    context: &'a mut StepContext<S, Q, N, R>,
    flow: &'a mut F,
    t1: f64,
    h: f64,
    kappa: SVector<f64, R>,
    va: SVector<f64, N>,
    q: SVector<f64, Q>,
    v: SVector<f64, N>,
    /// φ, and the residual of N v + n.
    defect: SVector<f64, R>,
    weights: SVector<f64, R>,
    is_first: bool,
    beside: bool,
}

impl<S, F, const Q: usize, const N: usize, const R: usize> Closing for Rows<'_, S, F, Q, N, R>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    const PATIENCE: i32 = 3;

    #[inline(always)]
    fn residual(&mut self) -> Result<f64, Fault> {
        let holonomic = S::STRUCTURE.holonomic_rows;
        let StepContext {
            system,
            end,
            work,
            scale,
            yardstick,
            ..
        } = &mut *self.context;
        let end = &mut **end;
        self.flow.positions(system, &self.va, &mut self.q)?;
        system.constraints(
            self.t1,
            &self.q,
            &mut work.phi,
            end.a.entries_mut(),
            &mut end.b,
        );
        end.metric(system, self.t1, &self.q)?;
        let mut v = self.flow.velocities(system, &self.va, &self.q, end);
        factor_holonomic(end, work);
        for i in holonomic..R {
            for j in 0..N {
                v[j] += end.w[i][j] * self.kappa[i];
            }
        }
        work.impulse[1] = self.kappa;
        project(end, work, &mut v, &scale.weights);
        self.defect = work.phi;
        for i in holonomic..R {
            self.defect[i] = end.velocity_row(i, &v);
        }
        if core::mem::take(&mut self.is_first) {
            // Kicks that cancel leave their round-off. A rate that moves no position is none.
            let speeds = vector(|i| self.va[i].abs() + v[i].abs());
            let floor = yardstick.imperceptible(&self.q, self.h) / scale.tolerance;
            let speed = yardstick.measure(&speeds).max(floor).max(AT_REST);
            for i in holonomic..R {
                self.weights[i] /= speed * speed;
            }
        }
        self.v = v;
        self.beside |= holonomic > 0 && work.delassus.beside;
        Ok(residual_of(&self.defect, &self.weights))
    }

    #[inline(always)]
    fn factor(&mut self) -> Result<bool, Fault> {
        let holonomic = S::STRUCTURE.holonomic_rows;
        let StepContext {
            system,
            start,
            end,
            work,
            scale,
            counters,
            ..
        } = &mut *self.context;
        let directions = self.flow.position_sensitivity(system, &self.va, start)?;
        system.delassus(&end.a, directions, &mut work.matrix);
        let far = self.flow.velocity_sensitivity(&start.w);
        for i in holonomic..R {
            let row = projected(end, work, i);
            for j in 0..R {
                work.matrix[i][j] = far.map_or(0.0, |far| dot(&row, &far[j]));
                if j >= holonomic {
                    work.matrix[i][j] += dot(&row, &end.w[j]);
                }
            }
        }
        // The kick of a nonholonomic row counts twice where the end follows the first one.
        let mut lengths = scale.lengths(start);
        let times = if far.is_some() { 2.0 } else { 1.0 };
        for length in &mut lengths.as_mut_slice()[holonomic..] {
            *length *= times;
        }
        let work = &mut **work;
        (work.projection).factor(&work.matrix, &lengths, work.delassus.skipped());
        counters.regularised += u64::from(work.projection.regularised);
        Ok(true)
    }

    #[inline(always)]
    fn solve(&mut self) -> bool {
        let StepContext { start, work, .. } = &mut *self.context;
        let mut change = self.defect;
        for value in &mut change.as_mut_slice()[..S::STRUCTURE.holonomic_rows] {
            *value /= self.h;
        }
        work.projection.solve(&mut change);
        change = negative(&change);
        add(&mut self.kappa, &change);
        accumulate(&mut self.va, &start.w, &change);
        self.flow.predict(&change);
        false
    }

    #[inline(always)]
    fn enough(&self) -> f64 {
        if self.beside { EXACT } else { 1.0 }
    }

    #[inline(always)]
    fn round_off(&self) -> f64 {
        let is_lost = self.context.work.projection.regularised;
        self.context.round_off_of_rows(is_lost, &self.q)
    }

    #[inline(always)]
    fn fault(&self, iterations: usize) -> Fault {
        let (defect, weights) = (self.defect, self.weights);
        not_converged(&defect, &weights, iterations)
    }
}

/// Projects v onto the holonomic velocity rows and adds the multipliers to the second impulse.
fn project<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    end: &ConstraintGeometry<S, Q, N, R>,
    work: &mut Workspace<R>,
    v: &mut SVector<f64, N>,
    weights: &SVector<f64, R>,
) {
    let holonomic = S::STRUCTURE.holonomic_rows;
    if holonomic == 0 {
        return;
    }
    work.impulse[1].as_mut_slice()[..holonomic].fill(0.0);
    let passes = if work.delassus.weak { REFINEMENTS } else { 1 };
    let mut rows = HolonomicRates {
        end,
        work,
        v,
        weights,
        rates: crate::linear::zeros(),
    };
    refine(&mut rows, passes, 0.0);
}

/// A v + b of the holonomic rows.
struct HolonomicRates<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    end: &'a ConstraintGeometry<S, Q, N, R>,
    work: &'a mut Workspace<R>,
    v: &'a mut SVector<f64, N>,
    weights: &'a SVector<f64, R>,
    rates: SVector<f64, R>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Refining
    for HolonomicRates<'_, S, Q, N, R>
{
    #[inline(always)]
    fn residual(&mut self) -> f64 {
        for i in 0..S::STRUCTURE.holonomic_rows {
            self.rates[i] = self.end.velocity_row(i, self.v);
        }
        residual_of(&self.rates, self.weights)
    }

    #[inline(always)]
    fn correct(&mut self) {
        let mut multiplier = negative(&self.rates);
        self.work.delassus.solve(&mut multiplier);
        accumulate(self.v, &self.end.w, &multiplier);
        for i in 0..S::STRUCTURE.holonomic_rows {
            self.work.impulse[1][i] += multiplier[i];
        }
    }
}

/// N₁ᵢ P, for the nonholonomic row i.
#[inline(always)]
fn projected<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    end: &ConstraintGeometry<S, Q, N, R>,
    work: &Workspace<R>,
    i: usize,
) -> SVector<f64, N> {
    let holonomic = S::STRUCTURE.holonomic_rows;
    let mut row = end.a[i];
    if holonomic > 0 {
        // P = 1 − W (A W)⁻¹ A.
        let mut factors = crate::linear::zeros();
        for k in 0..holonomic {
            factors[k] = -dot(&end.w[k], &row);
        }
        work.delassus.solve(&mut factors);
        accumulate(&mut row, &end.a, &factors);
    }
    row
}
