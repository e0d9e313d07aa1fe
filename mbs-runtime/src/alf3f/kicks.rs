//! Kick, flow, kick with holonomic rows only: the two-level form of ALF-3F.
//!
//! ```text
//! M₀ v_a = M₀ v₀ + A₀ᵀ κ₁      (26) with κ₁ = −M̄μ
//! (q₁, v_b) = Φ_h(q₀, v_a)
//! M₁ v₁ = M₁ v_b + A₁ᵀ κ₂
//! φ(q₁, t₁) = 0 → κ₁           A₁ v₁ + b₁ = 0 → κ₂
//! ```

use super::closing::{self, Closed, Closing, Limits, not_converged, residual_of};
use super::step_context::{PROMPT, StepContext};
use crate::System;
use crate::fault::Fault;
use crate::flow::KickFlow;
use crate::linear::{accumulate, add, scaled};
use crate::singular::EXACT;
use nalgebra::SVector;

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
    let t1 = context.end_time;
    let mut kick = Kick {
        kappa: context.state.expected_impulse(h),
        va: context.state.velocities,
        q: context.state.positions,
        by: Factor::None,
    };
    accumulate(&mut kick.va, &context.start.w, &kick.kappa);
    flow.begin(
        &context.system,
        [context.state.time, t1],
        &context.state.positions,
        [&context.state.velocities, &kick.va],
        &context.start,
        h,
    );
    // The first correction uses the factors of A₀M⁻¹A₀ᵀ from the velocity rows of the last step. With a
    // fixed number of corrections B is factored once for all of them.
    if flow.is_direct() && !weak_start && context.fixed_iterations.is_none() {
        kick.by = Factor::Start;
    }
    context.work.projection.regularised = false;
    let (mut exact, mut is_slow) = (beside, false);
    // In a loop, so that the iteration is compiled once.
    let v = loop {
        let Closed { left, iterations } = close(context, flow, h, &mut kick, exact)?;
        let v = arrive(context, flow, t1, &kick)?;
        is_slow |= iterations > PROMPT;
        let unforeseen = context.work.delassus.beside && !exact && left > EXACT;
        if !unforeseen || context.fixed_iterations.is_some() {
            break v;
        }
        // The step ends beside a singular pose, which was not known when its position rows were solved.
        (kick.by, exact) = (Factor::None, true);
    };
    if is_slow {
        context.check_kicks(h)?;
    }
    let weak = weak_start || context.work.delassus.weak || context.work.projection.regularised;
    context.commit(t1, h, kick.q, v, weak)?;
    if context.work.delassus.reduced {
        context.relieve_redundant();
    }
    Ok(())
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

/// The unknowns of the iteration.
struct Kick<const Q: usize, const N: usize, const R: usize> {
    kappa: SVector<f64, R>,
    va: SVector<f64, N>,
    q: SVector<f64, Q>,
    by: Factor,
}

/// What its corrections go through.
#[derive(PartialEq)]
enum Factor {
    None,
    /// A₀M⁻¹A₀ᵀ.
    Start,
    /// B.
    Projection,
}

/// Corrects κ₁ until φ(q₁) = 0, to round-off `beside` a singular pose; the residual is in squared tolerances.
#[inline(always)]
fn close<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    h: f64,
    kick: &mut Kick<Q, N, R>,
    beside: bool,
) -> Result<Closed, Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    let limits = Limits {
        most: context.max_iterations,
        fixed: context.fixed_iterations,
    };
    let factored = kick.by != Factor::None;
    let mut rows = Rows {
        t1: context.end_time,
        rate: -1.0 / h,
        context: &mut *context,
        flow,
        kick,
        enough: if beside { EXACT } else { 1.0 },
    };
    match closing::close(&mut rows, limits, factored)? {
        Some(closed) => {
            context.counters.iterations += closed.iterations as u64;
            Ok(closed)
        }
        None => unreachable!("the proximal solve loses no row"),
    }
}

/// The position rows at the end of a step, as functions of its first kick.
struct Rows<'a, S, F, const Q: usize, const N: usize, const R: usize>
where
    S: System<Q, N, R>,
{
    context: &'a mut StepContext<S, Q, N, R>,
    flow: &'a mut F,
    kick: &'a mut Kick<Q, N, R>,
    t1: f64,
    /// −1/h.
    rate: f64,
    enough: f64,
}

impl<S, F, const Q: usize, const N: usize, const R: usize> Closing for Rows<'_, S, F, Q, N, R>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    #[inline(always)]
    fn residual(&mut self) -> Result<f64, Fault> {
        let StepContext {
            system,
            end,
            work,
            scale,
            ..
        } = &mut *self.context;
        let Kick { va, q, .. } = &mut *self.kick;
        let end = &mut **end;
        self.flow.positions(system, va, q)?;
        system.constraints(self.t1, q, &mut work.phi, end.a.entries_mut(), &mut end.b);
        Ok(residual_of(&work.phi, &scale.weights))
    }

    #[inline(always)]
    fn factor(&mut self) -> Result<bool, Fault> {
        let StepContext {
            system,
            start,
            end,
            work,
            scale,
            counters,
            ..
        } = &mut *self.context;
        let directions = (self.flow).position_sensitivity(system, &self.kick.va, start)?;
        system.delassus(&end.a, directions, &mut work.matrix);
        let lengths = scale.lengths(start);
        let work = &mut **work;
        (work.projection).factor(&work.matrix, &lengths, work.delassus.skipped());
        counters.regularised += u64::from(work.projection.regularised);
        self.kick.by = Factor::Projection;
        Ok(true)
    }

    #[inline(always)]
    fn solve(&mut self) -> bool {
        let StepContext { start, work, .. } = &mut *self.context;
        let mut change = work.phi;
        if self.kick.by == Factor::Start {
            work.delassus.solve(&mut change);
        } else {
            work.projection.solve(&mut change);
        }
        change = scaled(self.rate, &change);
        add(&mut self.kick.kappa, &change);
        accumulate(&mut self.kick.va, &start.w, &change);
        self.flow.predict(&change);
        false
    }

    #[inline(always)]
    fn enough(&self) -> f64 {
        self.enough
    }

    #[inline(always)]
    fn round_off(&self) -> f64 {
        let is_lost = self.context.work.projection.regularised;
        self.context.round_off_of_rows(is_lost, &self.kick.q)
    }

    #[inline(always)]
    fn fault(&self, iterations: usize) -> Fault {
        let StepContext { work, scale, .. } = &*self.context;
        not_converged(&work.phi, &scale.weights, iterations)
    }
}
