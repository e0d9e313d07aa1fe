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
//! chain. A step that begins or ends where a row is about to lose its direction needs the proximal solve, which is dense:
//! that step is taken by [`kicks`].

use super::Fault;
use super::kicks::{self, EXACT, STAGNATED, residual_of};
use super::step_context::{REFINEMENTS, StepContext};
use crate::flow::Leapfrog;
use crate::generated::Elimination;
use crate::linear::{Bordered, Pair, RankMargin, Rows, Slots, SparseMass, Thresholds};
use crate::{State, System};

/// Corrections by the factor at the start of the step that are cheaper than another factor.
const PATIENCE: i32 = 3;

/// The factors at both ends of a step, and its workspace.
pub(crate) struct SparseKicks<const N: usize, const R: usize> {
    plan: &'static Elimination<N, R>,
    /// K where the state stands, factored.
    start: Bordered,
    end: Bordered,
    pair: Pair,
    mass: SparseMass,
    /// A vector in the order of elimination.
    x: Slots,
}

/// What the corrections of κ₁ go through.
#[derive(Clone, Copy, PartialEq)]
enum Factor {
    None,
    Start,
    Pair,
    Renewed,
}

/// What is iterated on: the first kick of a step, and where it leads.
struct Kick<const Q: usize, const N: usize, const R: usize> {
    /// q₁ without the velocity.
    base: [f64; N],
    q: [f64; Q],
    va: [f64; N],
    kappa: [f64; R],
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
    /// A workspace for the state in `core`; `None` where dense arrays are the faster.
    #[inline(never)]
    pub(super) fn new<S: System<Q, N, R>, const Q: usize>(
        context: &mut StepContext<S, Q, N, R>,
    ) -> Option<Box<Self>> {
        let plan = S::ELIMINATION?;
        let mass = crate::linear::constant_mass(&context.system, &context.state.positions);
        let matrix = Bordered::new(plan, &mass, context.work.delassus.thresholds);
        let mut kicks = Box::new(SparseKicks {
            plan,
            end: matrix.clone(),
            start: matrix,
            pair: Pair::new(plan),
            mass: SparseMass::new(plan, &mass),
            x: vec![0.0; plan.unknowns].into_boxed_slice(),
        });
        kicks.refresh(context);
        if kicks.start.leaves_rows_out(plan) {
            // Beside a singular pose the pivot of a redundant row is not small enough to tell it from one that is nearly lost.
            let coarse = Thresholds {
                lost: Thresholds::SECOND_ORDER.lost,
                ..context.work.delassus.thresholds
            };
            (kicks.start.thresholds, kicks.end.thresholds) = (coarse, coarse);
        }
        Some(kicks)
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
        mass.weigh_forces(
            self.plan,
            system,
            (*time, positions),
            x,
            &mut start.acceleration,
        );
    }

    /// A v + b at the current instant.
    pub(super) fn rates<S: System<Q, N, R>, const Q: usize>(
        &self,
        context: &StepContext<S, Q, N, R>,
    ) -> [f64; R] {
        rates(
            self.plan,
            &self.start,
            &context.start.b,
            &context.state.velocities,
        )
    }

    /// How independent the rows are at the current instant.
    pub(super) fn rank_margin(&self) -> RankMargin {
        self.start.rank_margin(self.plan)
    }

    /// How much each row takes part in what is nearest to a loss of independence.
    #[cold]
    pub(super) fn weakest_rows(&mut self) -> [f64; R] {
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
        context.refresh()?;
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
        let rows = loop {
            let Some(left) = self.close(context, h, &mut kick, enough) else {
                return Ok(Outcome::Lost);
            };
            self.end.factor(self.plan);
            let rows = self.end.rows(self.plan);
            if !(rows == Rows::Beside && left > EXACT && enough == 1.0) {
                break rows;
            }
            // It lands beside a singular pose, which was not known.
            kick.factor = Factor::None;
            enough = EXACT;
        };
        if rows == Rows::Lost {
            return Ok(Outcome::Lost);
        }
        let Kick { q, va, .. } = kick;
        let SparseKicks {
            plan, end, mass, x, ..
        } = self;
        let t1 = context.state.time + h;
        let (a0, geometry) = (&context.start.acceleration, &mut context.end);
        mass.weigh_forces(
            plan,
            &context.system,
            (t1, &q),
            x,
            &mut geometry.acceleration,
        );
        let a1 = &geometry.acceleration;
        let mut v: [f64; N] = std::array::from_fn(|i| va[i] + 0.5 * h * (a0[i] + a1[i]));
        let kappa = &mut context.work.impulse[1];
        *kappa = [0.0; R];
        let scale = &context.scale;
        // Zero, and never looked at, where the rows are independent.
        let mut enough = 0.0;
        if rows != Rows::Independent {
            enough = scale.round_off(context.yardstick.measure(&v));
        }
        let mut last = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            let rates = rates(plan, end, &geometry.b, &v).map(|rate| -rate);
            if rows != Rows::Independent {
                let residual = residual_of(&rates, &scale.weights);
                if residual <= enough || residual > 0.81 * last {
                    break;
                }
                last = residual;
            }
            end.solve(plan, &rates, x, (&mut v, kappa));
            if rows == Rows::Independent {
                break;
            }
        }
        context.commit(t1, h, q, v, weak_start || rows != Rows::Independent)?;
        std::mem::swap(&mut self.start, &mut self.end);
        Ok(Outcome::Done)
    }

    /// The kick that the last steps lead to expect, and where it leads.
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
        let mut va = [0.0; N];
        (plan.impulse)(&start.entries, &kappa, &mut va);
        mass.solve(plan, x, &mut va);
        for i in 0..N {
            va[i] += state.velocities[i];
        }
        let half = 0.5 * h * h;
        let a0 = &context.start.acceleration;
        Kick {
            base: std::array::from_fn(|i| state.positions[i] + half * a0[i]),
            q: state.positions,
            va,
            kappa,
            factor: match weak_start {
                true => Factor::None,
                false => Factor::Start,
            },
        }
    }

    /// Corrects the kick until φ(q₁) = 0 up to `enough` squared tolerances, with A₁ in `end`; what is left, `None` where
    /// it is not found.
    fn close<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        context: &mut StepContext<S, Q, N, R>,
        h: f64,
        kick: &mut Kick<Q, N, R>,
        enough: f64,
    ) -> Option<f64> {
        let SparseKicks {
            plan,
            start,
            end,
            pair,
            x,
            ..
        } = self;
        let work = &mut context.work;
        let (weights, t1) = (&context.scale.weights, context.state.time + h);
        let rate = -1.0 / h;
        let mut last = f64::INFINITY;
        let mut iterations = 0;
        let left = loop {
            for i in 0..N {
                kick.q[i] = kick.base[i] + h * kick.va[i];
            }
            context.system.sparse_constraints(
                t1,
                &kick.q,
                &mut work.phi,
                &mut end.entries,
                &mut context.end.b,
            );
            let residual = residual_of(&work.phi, weights);
            if residual <= enough || (residual <= 1.0 && residual >= 0.25 * last) {
                break residual;
            }
            let slow = iterations > 0 && !(residual.powi(PATIENCE + 1) <= last.powi(PATIENCE));
            if slow || kick.factor == Factor::None {
                if kick.factor == Factor::Renewed && residual > 0.5 * last && residual < STAGNATED {
                    break residual;
                }
                if iterations >= context.max_iterations || !residual.is_finite() {
                    return None;
                }
                if pair.factor(plan, start, end) == Rows::Lost {
                    return None;
                }
                kick.factor = Factor::Renewed;
            } else if kick.factor == Factor::Renewed {
                kick.factor = Factor::Pair;
            }
            let rates = work.phi.map(|phi| rate * phi);
            let to = (&mut kick.va, &mut kick.kappa);
            match kick.factor {
                Factor::Start => start.solve(plan, &rates, x, to),
                _ => pair.solve(plan, &rates, x, to),
            }
            last = residual;
            iterations += 1;
        };
        context.counters.iterations += iterations as u64;
        work.impulse[0] = kick.kappa;
        Some(left)
    }
}

#[inline]
fn rates<const N: usize, const R: usize>(
    plan: &Elimination<N, R>,
    matrix: &Bordered,
    b: &[f64; R],
    v: &[f64; N],
) -> [f64; R] {
    let mut rates = [0.0; R];
    (plan.rates)(&matrix.entries, v, &mut rates);
    std::array::from_fn(|i| rates[i] + b[i])
}
