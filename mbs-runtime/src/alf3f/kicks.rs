//! Kick, flow, kick with holonomic rows only: the two-level form of ALF-3F.
//!
//! ```text
//! M₀ v_a = M₀ v₀ + A₀ᵀ κ₁      (26) with κ₁ = −M̄μ
//! (q₁, v_b) = Φ_h(q₀, v_a)
//! M₁ v₁ = M₁ v_b + A₁ᵀ κ₂
//! φ(q₁, t₁) = 0 → κ₁           A₁ v₁ + b₁ = 0 → κ₂
//! ```

use super::Fault;
use super::step_context::StepContext;
use crate::System;
use crate::flow::KickFlow;
use crate::linear::accumulate;
use nalgebra::SVector;

/// What is left of φ beside a singular pose, in squared tolerances: there it turns velocities by φ/σ².
pub(super) const EXACT: f64 = 1e-6;
/// A residual this many times above its tolerance (squared) is taken when it no longer improves: round-off.
pub(super) const STAGNATED: f64 = 1e6;
/// The factorisation of mixed rows is renewed when (squared) residuals drop by less than this.
pub(super) const SLOW: f64 = 1e-2;

/// What the corrections of κ₁ go through.
#[derive(PartialEq)]
enum Matrix {
    None,
    /// A₀M⁻¹A₀ᵀ.
    Start,
    /// B, factored for this correction.
    Fresh,
    /// B of an earlier correction of this step.
    Kept,
}

pub(crate) fn step<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    h: f64,
) -> Result<(), Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    let (weak_start, beside) = (context.work.delassus.weak, context.work.delassus.beside);
    let t1 = context.state.time + h;
    let mut kick = Kick {
        kappa: context.state.expected_impulse(h),
        va: context.state.velocities,
        q: context.state.positions,
        matrix: Matrix::None,
    };
    accumulate(&mut kick.va, &context.start.w, &kick.kappa);
    flow.begin(
        &context.system,
        context.state.time,
        &context.state.positions,
        &kick.va,
        &context.start,
        h,
    );
    // The first correction goes through the factors of A₀M⁻¹A₀ᵀ, left by the velocity rows of the last step.
    // Where their number is fixed B is factored once, for all of them.
    if flow.is_direct() && !weak_start && context.fixed_iterations.is_none() {
        kick.matrix = Matrix::Start;
    }
    context.work.projection.regularised = false;
    let left = close(context, flow, h, &mut kick, beside)?;
    let mut v = arrive(context, flow, t1, &kick)?;
    let unforeseen = context.work.delassus.beside && !beside && left > EXACT;
    if unforeseen && context.fixed_iterations.is_none() {
        v = close_again(context, flow, h, &mut kick)?;
    }
    let weak = weak_start || context.work.delassus.weak || context.work.projection.regularised;
    context.commit(t1, h, kick.q, v, weak)
}

/// The velocities at the end of the step, on the rows there.
#[inline(always)]
fn arrive<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    t1: f64,
    kick: &Kick<Q, N, R>,
) -> Result<SVector<f64, N>, Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    context.work.impulse[0] = kick.kappa;
    context.end.metric(&context.system, t1, &kick.q)?;
    let mut v = flow.velocities(&context.system, &kick.va, &kick.q, &mut context.end);
    context.project_velocity(&mut v);
    Ok(v)
}

/// The step has landed beside a singular pose, which was not known when its rows were closed.
#[cold]
#[inline(never)]
fn close_again<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    h: f64,
    kick: &mut Kick<Q, N, R>,
) -> Result<SVector<f64, N>, Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    kick.matrix = Matrix::None;
    close(context, flow, h, kick, true)?;
    arrive(context, flow, context.state.time + h, kick)
}

/// What is iterated on.
struct Kick<const Q: usize, const N: usize, const R: usize> {
    kappa: SVector<f64, R>,
    va: SVector<f64, N>,
    q: SVector<f64, Q>,
    matrix: Matrix,
}

/// Corrects κ₁ until φ(q₁) = 0, to round-off `beside` a singular pose; what is left, in squared tolerances.
#[inline(always)]
fn close<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    h: f64,
    kick: &mut Kick<Q, N, R>,
    beside: bool,
) -> Result<f64, Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    let StepContext {
        system,
        state,
        max_iterations,
        fixed_iterations,
        start,
        end,
        work,
        scale,
        counters,
        ..
    } = context;
    let Kick {
        kappa,
        va,
        q,
        matrix,
    } = kick;
    let t1 = state.time + h;
    let fixed = *fixed_iterations;
    let weights = &scale.weights;
    let rate = 1.0 / h;
    let mut last = f64::INFINITY;
    let mut iterations = 0;
    let left = loop {
        flow.positions(system, va, q)?;
        system.constraints(t1, q, &mut work.phi, &mut end.a, &mut end.b);
        let residual = residual_of(&work.phi, weights);
        match fixed {
            // Beside a singular pose down to round-off.
            None if residual <= 1.0
                && (!beside || residual <= EXACT || residual >= 0.25 * last) =>
            {
                break residual;
            }
            Some(count) if iterations == count && residual.is_finite() => break residual,
            _ => {}
        }
        // Renewed where one more correction at the present rate would not do.
        let slow = !(residual * residual <= last) && iterations > 0;
        let slow = slow && (fixed.is_none() || !residual.is_finite());
        if *matrix == Matrix::None || slow {
            let taken = if work.projection.regularised {
                scale.lost
            } else {
                STAGNATED
            };
            if *matrix == Matrix::Fresh && residual > 0.5 * last && residual < taken {
                break residual;
            }
            if (iterations >= *max_iterations && fixed.is_none()) || !residual.is_finite() {
                return Err(not_converged(&work.phi, weights, iterations));
            }
            let directions = flow.position_sensitivity(system, va, start)?;
            system.delassus(&end.a, directions, &mut work.matrix);
            (work.projection).factor(
                &work.matrix,
                &start.lengths_squared(),
                work.delassus.skipped(),
            );
            counters.regularised += u64::from(work.projection.regularised);
            *matrix = Matrix::Fresh;
        } else if *matrix == Matrix::Fresh {
            *matrix = Matrix::Kept;
        }
        let mut change = work.phi;
        if *matrix == Matrix::Start {
            work.delassus.solve(&mut change);
        } else {
            work.projection.solve(&mut change);
        }
        for i in 0..R {
            change[i] *= -rate;
            kappa[i] += change[i];
        }
        accumulate(va, &start.w, &change);
        flow.predict(&change);
        last = residual;
        iterations += 1;
    };
    counters.iterations += iterations as u64;
    Ok(left)
}

/// Σ φ_i² / tolerance_i²: one at most where every row is within its tolerance and their sum is; NaN if any row is.
#[inline(always)]
pub(crate) fn residual_of<const R: usize>(phi: &SVector<f64, R>, weights: &SVector<f64, R>) -> f64 {
    let mut sum = 0.0;
    for i in 0..R {
        sum += phi[i] * phi[i] * weights[i];
    }
    sum
}

#[cold]
#[inline(never)]
pub(crate) fn not_converged<const R: usize>(
    phi: &SVector<f64, R>,
    weights: &SVector<f64, R>,
    iterations: usize,
) -> Fault {
    let mut row = 0;
    for i in 0..R {
        let size = |i: usize| phi[i] * phi[i] * weights[i];
        if !(size(i) <= size(row)) {
            row = i;
        }
    }
    match phi.get(row) {
        Some(residual) if !residual.is_finite() => Fault::NonFinite("constraint rows"),
        residual => Fault::Row {
            row,
            residual: residual.copied().unwrap_or(0.0),
            iterations,
        },
    }
}
