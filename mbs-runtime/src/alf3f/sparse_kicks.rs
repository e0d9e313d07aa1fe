//! Kick, flow, kick without dense arrays, for large mechanisms: leapfrog, holonomic rows, constant M.
//!
//! The equations are those of [`kicks`]; each solution with S or B is one with
//!
//! ```text
//! [ M  A₀ᵀ ] [ δv  ]   [ 0 ]
//! [ A₁  0  ] [ −δκ ] = [ r ]
//! ```
//!
//! whose elimination was planned when the mechanism was compiled, and takes operations in proportion to the length of a
//! chain. A step that begins or ends where rows are nearly dependent needs the proximal solve, which is dense;
//! [`kicks`] takes that step.

use super::closing::residual_of;
use super::closing::{self, Closed, Closing, Limits, Refining, refine};
use super::kicks;
use super::sparse::{Bordered, Pair, Rows, Slots, SparseMass};
use super::step_context::{PROMPT, REFINEMENTS, StepContext};
use crate::contract::mass_rows;
use crate::fault::Fault;
use crate::flow::Leapfrog;
use crate::generated::Elimination;
use crate::large::{kick_elimination, starts_sparse};
use crate::linear::{entries, entries_mut, vector, zeros};
use crate::memory::zeroed;
use crate::singular::{EXACT, RankMargin, Thresholds};
use crate::{State, System};
use nalgebra::SVector;

/// The factors at both ends of a step, and its workspace.
#[derive(Clone)]
pub(crate) struct SparseKicks<const N: usize, const R: usize> {
    plan: &'static Elimination<N, R>,
    /// K at the current state, factored.
    start: Bordered,
    end: Bordered,
    pair: Pair<N, R>,
    mass: SparseMass<N, R>,
    /// A vector in the order of elimination.
    x: Slots,
    /// Right-hand sides of the rows. (A long vector that a function returns is copied, and does not stay in the cache.)
    right: Box<SVector<f64, R>>,
}

/// The matrix for the corrections of κ₁.
#[derive(Clone, Copy, PartialEq)]
enum Factor {
    None,
    Start,
    Pair,
}

/// What is iterated on: the first kick of a step, and where it leads.
struct Kick<const Q: usize, const N: usize, const R: usize> {
    /// q₁ without the velocity.
    base: SVector<f64, Q>,
    q: SVector<f64, Q>,
    va: SVector<f64, N>,
    kappa: SVector<f64, R>,
    factor: Factor,
}

/// How a step ended.
#[derive(Debug, PartialEq)]
enum Outcome {
    Done,
    /// A row is about to lose its direction at one end of the step.
    Lost,
}

impl<const N: usize, const R: usize> SparseKicks<N, R> {
    /// The smallest relative pivot at the declared guess, 1 at most, where the mechanism is so large that only steps near
    /// singular poses have dense arrays; `None` where all have them.
    pub(super) fn usual_pivot<S: System<Q, N, R>, const Q: usize>(system: &S) -> Option<f64> {
        if const { !starts_sparse::<N, R>() || kick_elimination::<S, Q, N, R>().is_none() } {
            return None;
        }
        let plan = kick_elimination::<S, Q, N, R>()?;
        let (q, _) = system.guess();
        let mut matrix = Bordered::new(plan, &mass_rows(system, &q), Thresholds::SECOND_ORDER);
        system.sparse_constraints(0.0, &q, &mut zeros(), &mut matrix.entries, &mut zeros());
        matrix.factor(plan);
        Some(matrix.least_pivot(plan))
    }

    /// A workspace for the state in `core`; `None` where dense arrays are the faster.
    #[inline(never)]
    pub(super) fn new<S: System<Q, N, R>, const Q: usize>(
        context: &mut StepContext<S, Q, N, R>,
    ) -> Option<Box<Self>> {
        if const { kick_elimination::<S, Q, N, R>().is_none() } {
            return None;
        }
        let plan = kick_elimination::<S, Q, N, R>()?;
        let functions = plan.kicks.as_ref()?;
        let mass = mass_rows(&context.system, &context.state.positions);
        let matrix = Bordered::new(plan, &mass, context.work.delassus.thresholds);
        let mut kicks = Box::new(SparseKicks {
            plan,
            end: matrix.clone(),
            start: matrix,
            pair: Pair::new(plan, functions),
            mass: SparseMass::new(functions, &mass),
            x: vec![0.0; plan.unknowns].into_boxed_slice(),
            right: zeroed(),
        });
        kicks.refresh(context);
        kicks.free_redundant();
        Some(kicks)
    }

    /// Frees the rows that are redundant in every pose.
    ///
    /// Beside a singular pose the pivot of such a row is not small enough to distinguish it from a nearly dependent one.
    fn free_redundant(&mut self) {
        let plan = self.plan;
        let here = self.start.left_out(plan);
        if here == 0 {
            return;
        }
        if here == plan.redundant {
            self.start.free_dependent(plan);
            self.end = self.start.clone();
        } else {
            // A singular pose, or parameters with which other rows are redundant.
            let coarse = Thresholds {
                lost: Thresholds::SECOND_ORDER.lost,
                ..self.start.thresholds
            };
            (self.start.thresholds, self.end.thresholds) = (coarse, coarse);
        }
    }

    /// Recomputes what is known of the current instant.
    pub(super) fn refresh<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
    ) {
        let State {
            time, positions, ..
        } = &context.state;
        let (start, system) = (&mut context.start, &context.system);
        system.sparse_constraints(
            *time,
            positions,
            &mut context.work.phi,
            &mut self.start.entries,
            &mut start.b,
        );
        self.start.factor(self.plan);
        let (mass, x) = (&self.mass, &mut self.x);
        mass.weigh_forces(system, (*time, positions), x, &mut start.acceleration);
    }

    /// A v + b at the current instant.
    pub(super) fn rates<S: System<Q, N, R>, const Q: usize>(
        &self,
        context: &StepContext<S, Q, N, R>,
    ) -> SVector<f64, R> {
        let mut rates = zeros();
        let (b, v) = (&context.start.b, &context.state.velocities);
        write_rates(self.plan, &self.start, (b, v), &mut rates);
        rates
    }

    /// How independent the rows are at the current instant.
    pub(super) fn rank_margin(&self) -> RankMargin {
        self.start.rank_margin(self.plan, R)
    }

    /// The weight of each row in the combination that is nearest to dependence.
    #[cold]
    pub(super) fn weakest_rows(&mut self) -> SVector<f64, R> {
        self.start.combination(self.plan, &mut self.x)
    }

    pub(super) fn step<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        flow: &mut Leapfrog<Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        if self.attempt(context, h)? == Outcome::Done {
            return Ok(());
        }
        context.fill_dense()?;
        kicks::step(context, flow, h)?;
        self.refresh(context);
        Ok(())
    }

    fn attempt<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
    ) -> Result<Outcome, Fault> {
        let start = self.start.rows(self.plan);
        if start == Rows::Lost {
            return Ok(Outcome::Lost);
        }
        let weak_start = start != Rows::Independent;
        let mut kick = self.depart(context, h, weak_start);
        let mut enough = if start == Rows::Beside { EXACT } else { 1.0 };
        let mut many = false;
        let rows = loop {
            let Some(Closed { left, iterations }) = self.close(context, h, &mut kick, enough)
            else {
                return Ok(Outcome::Lost);
            };
            many |= iterations > PROMPT;
            self.end.factor(self.plan);
            let rows = self.end.rows(self.plan);
            if !(rows == Rows::Beside && left > EXACT && enough == 1.0) {
                break rows;
            }
            // It ends beside a singular pose, which was not known.
            kick.factor = Factor::None;
            enough = EXACT;
        };
        if rows == Rows::Lost {
            return Ok(Outcome::Lost);
        }
        let (q, va) = (&kick.q, &kick.va);
        let SparseKicks {
            plan,
            end,
            mass,
            x,
            right,
            ..
        } = &mut *self;
        let t1 = context.end_time;
        let (a0, geometry) = (&context.start.acceleration, &mut context.end);
        mass.weigh_forces(&context.system, (t1, q), x, &mut geometry.acceleration);
        let a1 = &geometry.acceleration;
        let mut v: SVector<f64, N> = vector(|i| va[i] + 0.5 * h * (a0[i] + a1[i]));
        let kappa = &mut context.work.impulse[1];
        *kappa = SVector::zeros();
        let scale = &context.scale;
        // Zero, and never looked at, where the rows are independent.
        let mut enough = 0.0;
        if rows != Rows::Independent {
            enough = scale.round_off(context.yardstick.measure(&v));
        }
        let passes = match rows {
            Rows::Independent => 1,
            _ => REFINEMENTS,
        };
        let mut left = Rates {
            plan,
            matrix: end,
            b: &geometry.b,
            weights: &scale.weights,
            x,
            v: &mut v,
            kappa,
            rates: right,
        };
        refine(&mut left, passes, enough);
        if many {
            let (v0, a1) = (&context.state.velocities, &context.end.acceleration);
            let a0 = &context.start.acceleration;
            // The kick at the beginning less the one at the end.
            let apart = vector(|i| 2.0 * va[i] - v0[i] - v[i] + 0.5 * h * (a0[i] + a1[i]));
            context.check_way(0.5 * h, &apart)?;
        }
        context.commit(t1, h, *q, v, weak_start || rows != Rows::Independent)?;
        core::mem::swap(&mut self.start, &mut self.end);
        Ok(Outcome::Done)
    }

    /// The kick extrapolated from the last steps, and the positions after it.
    fn depart<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        context: &StepContext<S, Q, N, R>,
        h: f64,
        weak_start: bool,
    ) -> Kick<Q, N, R> {
        let SparseKicks {
            plan,
            start,
            mass,
            x,
            ..
        } = self;
        let state = &context.state;
        let kappa = state.expected_impulse(h);
        let mut va = zeros();
        (plan.impulse)(&start.entries, &kappa, &mut va);
        mass.solve(x, &mut va);
        for i in 0..N {
            va[i] += state.velocities[i];
        }
        let half = 0.5 * h * h;
        let a0 = &context.start.acceleration;
        Kick {
            base: match Q == N {
                true => vector(|i| state.positions[i] + half * a0[i]),
                false => context.system.advance(&state.positions, a0, half),
            },
            q: state.positions,
            va,
            kappa,
            factor: match weak_start {
                true => Factor::None,
                false => Factor::Start,
            },
        }
    }

    /// Corrects the kick until φ(q₁) = 0 up to `enough` squared tolerances, with A₁ in `end`; returns the residual,
    /// `None` without convergence.
    fn close<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
        kick: &mut Kick<Q, N, R>,
        enough: f64,
    ) -> Option<Closed> {
        let limits = Limits {
            most: context.max_iterations,
            fixed: None,
        };
        let factored = kick.factor != Factor::None;
        let mut rows = Ends {
            t1: context.end_time,
            context: &mut *context,
            kicks: self,
            kick,
            h,
            enough,
        };
        let closed = closing::close(&mut rows, limits, factored).ok()??;
        context.counters.iterations += closed.iterations as u64;
        context.work.impulse[0] = kick.kappa;
        Some(closed)
    }
}

/// The position rows at the end of a step, as functions of its first kick.
struct Ends<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    context: &'a mut StepContext<S, Q, N, R>,
    kicks: &'a mut SparseKicks<N, R>,
    kick: &'a mut Kick<Q, N, R>,
    t1: f64,
    h: f64,
    enough: f64,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Closing
    for Ends<'_, S, Q, N, R>
{
    const PATIENCE: i32 = 3;

    fn round_off(&self) -> f64 {
        self.context.round_off_of_rows(false, &self.kick.q)
    }

    #[inline(always)]
    fn residual(&mut self) -> Result<f64, Fault> {
        let StepContext {
            system,
            end,
            work,
            scale,
            ..
        } = &mut *self.context;
        let kick = &mut *self.kick;
        if Q == N {
            for i in 0..N {
                kick.q[i] = kick.base[i] + self.h * kick.va[i];
            }
        } else {
            // Counted angles are stored beside the coordinates.
            kick.q = system.advance(&kick.base, &kick.va, self.h);
        }
        let entries = &mut self.kicks.end.entries;
        system.sparse_constraints(self.t1, &kick.q, &mut work.phi, entries, &mut end.b);
        Ok(residual_of(&work.phi, &scale.weights))
    }

    #[inline(always)]
    fn factor(&mut self) -> Result<bool, Fault> {
        let SparseKicks {
            plan,
            start,
            end,
            pair,
            ..
        } = &mut *self.kicks;
        self.kick.factor = Factor::Pair;
        Ok(pair.factor(plan, start, end) != Rows::Lost)
    }

    #[inline(always)]
    fn solve(&mut self) -> bool {
        let SparseKicks {
            plan,
            start,
            pair,
            x,
            right,
            ..
        } = &mut *self.kicks;
        let rate = -1.0 / self.h;
        let phi = entries(&self.context.work.phi);
        for (right, phi) in entries_mut(right).iter_mut().zip(phi) {
            *right = rate * phi;
        }
        let to = (&mut self.kick.va, &mut self.kick.kappa);
        match self.kick.factor {
            Factor::Start => start.solve(plan, right, x, to),
            _ => pair.solve(right, x, to),
        }
        false
    }

    #[inline(always)]
    fn enough(&self) -> f64 {
        self.enough
    }

    /// The dense step reports the error.
    #[inline(always)]
    fn fault(&self, _: usize) -> Fault {
        Fault::NonFinite("constraint rows")
    }
}

/// A v + b at the end of a step.
struct Rates<'a, const N: usize, const R: usize> {
    plan: &'static Elimination<N, R>,
    matrix: &'a Bordered,
    b: &'a SVector<f64, R>,
    weights: &'a SVector<f64, R>,
    x: &'a mut [f64],
    v: &'a mut SVector<f64, N>,
    kappa: &'a mut SVector<f64, R>,
    rates: &'a mut SVector<f64, R>,
}

impl<const N: usize, const R: usize> Refining for Rates<'_, N, R> {
    #[inline(always)]
    fn residual(&mut self) -> f64 {
        write_rates(self.plan, self.matrix, (self.b, self.v), self.rates);
        residual_of(self.rates, self.weights)
    }

    #[inline(always)]
    fn correct(&mut self) {
        for rate in entries_mut(self.rates) {
            *rate = -*rate;
        }
        let to = (&mut *self.v, &mut *self.kappa);
        self.matrix.solve(self.plan, self.rates, self.x, to);
    }
}

/// A v + b.
#[inline]
fn write_rates<const N: usize, const R: usize>(
    plan: &Elimination<N, R>,
    matrix: &Bordered,
    (b, v): (&SVector<f64, R>, &SVector<f64, N>),
    rates: &mut SVector<f64, R>,
) {
    entries_mut(rates).fill(0.0);
    (plan.rates)(&matrix.entries, v, rates);
    for (rate, b) in entries_mut(rates).iter_mut().zip(entries(b)) {
        *rate += b;
    }
}
