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
use super::core::{Core, REFINEMENTS};
use super::kicks::{self, STAGNATED, residual_of};
use crate::flow::Leapfrog;
use crate::generated::Elimination;
use crate::linear::{Bordered, Independence, Pair, Rows, Slots, SparseMass, largest};
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
    Start,
    Pair,
    Renewed,
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
        core: &mut Core<S, Q, N, R>,
    ) -> Option<Box<Self>> {
        let plan = S::ELIMINATION?;
        let mass = crate::linear::constant_mass(&core.system, &core.state.positions);
        let matrix = Bordered::new(plan, &mass);
        let mut kicks = Box::new(SparseKicks {
            plan,
            end: matrix.clone(),
            start: matrix,
            pair: Pair::new(plan),
            mass: SparseMass::new(plan, &mass),
            x: vec![0.0; plan.unknowns].into_boxed_slice(),
        });
        kicks.refresh(core);
        Some(kicks)
    }

    /// Recomputes what is known of the current instant.
    pub(super) fn refresh<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        core: &mut Core<S, Q, N, R>,
    ) {
        let State {
            time, positions, ..
        } = &core.state;
        let (start, system) = (&mut core.start, &core.system);
        system.sparse_constraints(
            *time,
            positions,
            &mut core.work.phi,
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
        core: &Core<S, Q, N, R>,
    ) -> [f64; R] {
        rates(
            self.plan,
            &self.start,
            &core.start.b,
            &core.state.velocities,
        )
    }

    /// How independent the rows are at the current instant.
    pub(super) fn independence(&self) -> Independence {
        self.start.independence(self.plan)
    }

    /// How much each row takes part in what is nearest to a loss of independence.
    #[cold]
    pub(super) fn weakest_rows(&mut self) -> [f64; R] {
        self.start.combination(self.plan, &mut self.x)
    }

    pub(super) fn step<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        core: &mut Core<S, Q, N, R>,
        flow: &mut Leapfrog<Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        if self.attempt(core, h)? == Outcome::Done {
            return Ok(());
        }
        core.refresh()?;
        kicks::step(core, flow, h)?;
        self.refresh(core);
        Ok(())
    }

    fn attempt<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        core: &mut Core<S, Q, N, R>,
        h: f64,
    ) -> Result<Outcome, Fault> {
        let weak_start = match self.start.rows(self.plan) {
            Rows::Independent => false,
            Rows::Weak => true,
            Rows::Lost => return Ok(Outcome::Lost),
        };
        let Some((q, va)) = self.positions(core, h, weak_start) else {
            return Ok(Outcome::Lost);
        };
        let SparseKicks {
            plan, end, mass, x, ..
        } = self;
        end.factor(plan);
        let rows = end.rows(plan);
        if rows == Rows::Lost {
            return Ok(Outcome::Lost);
        }
        let t1 = core.state.time + h;
        let (a0, node) = (&core.start.acceleration, &mut core.end);
        mass.weigh_forces(plan, &core.system, (t1, &q), x, &mut node.acceleration);
        let a1 = &node.acceleration;
        let mut v: [f64; N] = std::array::from_fn(|i| va[i] + 0.5 * h * (a0[i] + a1[i]));
        let kappa = &mut core.work.impulse[1];
        *kappa = [0.0; R];
        let tolerance = 1e-14 * largest(&v);
        let mut last = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            let rates = rates(plan, end, &node.b, &v).map(|rate| -rate);
            if rows == Rows::Weak {
                let residual = largest(&rates);
                if residual <= tolerance || residual > 0.9 * last {
                    break;
                }
                last = residual;
            }
            end.solve(plan, &rates, x, (&mut v, kappa));
            if rows == Rows::Independent {
                break;
            }
        }
        core.commit(t1, h, q, v, weak_start || rows == Rows::Weak)?;
        std::mem::swap(&mut self.start, &mut self.end);
        Ok(Outcome::Done)
    }

    /// q₁ and v_a with φ(q₁) = 0, and A₁ in `end`; `None` where they are not found.
    fn positions<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        core: &mut Core<S, Q, N, R>,
        h: f64,
        weak_start: bool,
    ) -> Option<([f64; Q], [f64; N])> {
        let SparseKicks {
            plan,
            start,
            end,
            pair,
            mass,
            x,
        } = self;
        let (state, work) = (&core.state, &mut core.work);
        let (weights, t1) = (&core.scale.weights, state.time + h);

        let mut kappa = state.expected_impulse(h);
        let mut va = [0.0; N];
        (plan.impulse)(&start.entries, &kappa, &mut va);
        mass.solve(plan, x, &mut va);
        for i in 0..N {
            va[i] += state.velocities[i];
        }
        let half = 0.5 * h * h;
        let a0 = &core.start.acceleration;
        let base: [f64; N] = std::array::from_fn(|i| state.positions[i] + half * a0[i]);
        let mut q = state.positions;
        let rate = -1.0 / h;
        let mut factor = Factor::Start;
        let mut last = f64::INFINITY;
        let mut iterations = 0;
        loop {
            for i in 0..N {
                q[i] = base[i] + h * va[i];
            }
            core.system.sparse_constraints(
                t1,
                &q,
                &mut work.phi,
                &mut end.entries,
                &mut core.end.b,
            );
            let residual = residual_of(&work.phi, weights);
            if residual <= 1.0 {
                break;
            }
            let slow = iterations > 0 && !(residual.powi(PATIENCE + 1) <= last.powi(PATIENCE));
            if slow || (factor == Factor::Start && weak_start) {
                if factor == Factor::Renewed && residual > 0.5 * last && residual < STAGNATED {
                    break;
                }
                if iterations >= core.max_iterations || !residual.is_finite() {
                    return None;
                }
                if pair.factor(plan, start, end) == Rows::Lost {
                    return None;
                }
                factor = Factor::Renewed;
            } else if factor == Factor::Renewed {
                factor = Factor::Pair;
            }
            let rates = work.phi.map(|phi| rate * phi);
            match factor {
                Factor::Start => start.solve(plan, &rates, x, (&mut va, &mut kappa)),
                _ => pair.solve(plan, &rates, x, (&mut va, &mut kappa)),
            }
            last = residual;
            iterations += 1;
        }
        core.counters.iterations += iterations as u64;
        work.impulse[0] = kappa;
        Some((q, va))
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
