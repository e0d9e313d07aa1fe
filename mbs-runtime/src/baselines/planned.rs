//! Accelerations and projections of large mechanisms by the elimination that was planned when they were compiled:
//! operations in proportion to the length of a chain.
//!
//! ```text
//! [ M  Aᵀ ] [ v̇  ]   [ F − ṗ|_v ]
//! [ A  0  ] [ −λ ] = [ −γ − …   ]
//! ```
//!
//! Rows are eliminated as long as they have a pivot, and weak ones are solved again for what is left of them. Where a row
//! has none the solution is the proximal one (`planned_proximal.rs`), also in the rest of a step: its stages violate a row
//! that was lost before, and turn velocities by the violation over σ² where it is enforced too soon. Mechanisms with
//! redundant rows have dense equations beside their poses: rows that are left out may have a direction which those that are
//! kept have lost.

use super::bench::Bench;
use super::planned_proximal::{Equations, PlannedProximal};
use crate::System;
use crate::alf3f::closing::{self, Closed, Closing, Limits};
use crate::alf3f::sparse::{Bordered, Rows, Slots};
use crate::alf3f::{Counters, not_converged, residual_of};
use crate::contract::mass_rows;
use crate::fault::Fault;
use crate::free::write_free_forces;
use crate::generated::Elimination;
use crate::linear::{negative, vector};
use crate::row_scale::RowScale;
use crate::singular::{EXACT, RankMargin, Thresholds};
use crate::sink::Discard;
use nalgebra::SVector;

/// K at one instant with its factor.
#[derive(Clone)]
pub(crate) struct Planned<const N: usize, const R: usize> {
    plan: &'static Elimination<N, R>,
    matrix: Bordered,
    /// Instead of its factor where rows are lost.
    proximal: PlannedProximal<N, R>,
    /// A vector in the order of elimination.
    x: Slots,
    rows: Rows,
    /// In a step, until a row is lost in it, and from then on.
    thresholds: [Thresholds; 2],
    has_lost: bool,
}

impl<const N: usize, const R: usize> Planned<N, R> {
    /// `None` where dense arrays are the faster, and at starts where redundant rows cannot be told from others. Rows that
    /// follow from others in general are left out from here on: their pivots are not zero in stages that violate the rows.
    #[inline(never)]
    pub(crate) fn new<S: System<Q, N, R>, const Q: usize>(
        bench: &Bench<S, Q, N, R>,
        dense: Thresholds,
    ) -> Option<Box<Self>> {
        let plan = S::ELIMINATION?;
        let thresholds = match plan.redundant {
            0 => [Thresholds::ELIMINATED, dense],
            _ => [dense; 2],
        };
        let (system, state) = (&bench.system, &bench.state);
        let mass = mass_rows(system, &state.positions);
        let mut planned = Box::new(Planned {
            plan,
            matrix: Bordered::new(plan, &mass, thresholds[0]),
            proximal: PlannedProximal::new(plan),
            x: vec![0.0; plan.unknowns].into_boxed_slice(),
            rows: Rows::Lost,
            thresholds,
            has_lost: false,
        });
        if plan.redundant == 0 {
            return Some(planned);
        }
        let matrix = &mut planned.matrix;
        let (mut phi, mut b) = (SVector::zeros(), SVector::zeros());
        system.sparse_constraints(
            state.time,
            &state.positions,
            &mut phi,
            &mut matrix.entries,
            &mut b,
        );
        matrix.factor(plan);
        if matrix.left_out(plan) != plan.redundant {
            return None;
        }
        matrix.free_dependent(plan);
        Some(planned)
    }

    /// A step begins.
    pub(crate) fn begin(&mut self) {
        self.has_lost = false;
    }

    fn factor(&mut self, counters: &mut Counters) {
        self.matrix.factor(self.plan);
        self.matrix.thresholds = self.thresholds[usize::from(self.has_lost)];
        self.rows = self.matrix.all_rows(self.plan);
        if self.rows == Rows::Lost && self.is_sound() {
            self.has_lost = true;
            self.proximal.factor(self.plan, &self.matrix);
            counters.regularised += 1;
        }
    }

    /// Whether there are solutions here: otherwise dense equations are needed.
    pub(crate) fn is_sound(&self) -> bool {
        self.rows != Rows::Lost || !self.leaves_rows_out()
    }

    fn evaluate<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
    ) {
        let entries = &mut self.matrix.entries;
        let (phi, b) = (&mut bench.phi, &mut bench.geometry.b);
        bench.system.sparse_constraints(t, q, phi, entries, b);
        if !S::STRUCTURE.constant_mass {
            bench.system.sparse_mass(q, entries);
        }
    }

    /// K at (t, q), factored; false where the dense equations are needed.
    pub(crate) fn place<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &SVector<f64, Q>,
    ) -> bool {
        self.evaluate(bench, t, q);
        self.factor(&mut bench.counters);
        self.is_sound()
    }

    /// v̇ where it was placed, and λ, for A v̇ + `demand` = 0.
    pub(crate) fn acceleration<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        system: &S,
        (t, q, v): (f64, &SVector<f64, Q>, &SVector<f64, N>),
        demand: &SVector<f64, R>,
        lambda: &mut SVector<f64, R>,
    ) -> SVector<f64, N> {
        let mut acceleration = SVector::zeros();
        write_free_forces(system, t, q, v, &mut acceleration);
        if self.rows == Rows::Lost {
            let equations = Equations {
                plan: self.plan,
                entries: &self.matrix.entries,
                demand,
            };
            (self.proximal).accelerate(&equations, &mut self.x, &mut acceleration, lambda);
            return acceleration;
        }
        *lambda = negative(demand);
        let right = (&mut acceleration, &mut *lambda);
        (self.matrix).accelerate(self.plan, &mut self.x, right);
        if self.rows == Rows::Weak {
            // What the elimination has lost.
            self.correct(demand, &mut acceleration, lambda);
        }
        acceleration
    }

    /// A v where it was placed.
    pub(crate) fn rates(&self, v: &SVector<f64, N>) -> SVector<f64, R> {
        let mut rates = SVector::zeros();
        (self.plan.rates)(&self.matrix.entries, v, &mut rates);
        rates
    }

    /// Moves v along M⁻¹Aᵀ until A v + `demand` = 0; adds the multipliers to κ.
    fn correct(
        &mut self,
        demand: &SVector<f64, R>,
        v: &mut SVector<f64, N>,
        kappa: &mut SVector<f64, R>,
    ) {
        if self.rows == Rows::Lost {
            let equations = Equations {
                plan: self.plan,
                entries: &self.matrix.entries,
                demand,
            };
            return (self.proximal).correct(&equations, &mut self.x, v, kappa);
        }
        let rates = self.rates(v);
        let missing = vector(|i| -(rates[i] + demand[i]));
        (self.matrix).solve(self.plan, &missing, &mut self.x, (v, kappa));
    }

    /// The shortest displacement that changes φ by −`phi`.
    fn displacement(&mut self, phi: &SVector<f64, R>) -> SVector<f64, N> {
        let (mut way, mut kappa) = (SVector::zeros(), SVector::zeros());
        if self.rows == Rows::Lost {
            self.correct(phi, &mut way, &mut kappa);
        } else {
            let into = (&mut way, &mut kappa);
            (self.matrix).solve(self.plan, &negative(phi), &mut self.x, into);
        }
        way
    }

    /// Moves q onto the position rows, with the factors of where it was first, and evaluates the rows there for the
    /// bench; `None` where the dense equations are needed.
    pub(crate) fn close<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &mut SVector<f64, Q>,
        scale: &RowScale<R>,
    ) -> Result<Option<Closed>, Fault> {
        if !self.place(bench, t, q) {
            return Ok(None);
        }
        let limits = Limits {
            most: bench.max_iterations,
            fixed: None,
        };
        let mut rows = Near {
            planned: self,
            bench: &mut *bench,
            scale,
            t,
            q,
            is_evaluated: true,
        };
        let closed = closing::close(&mut rows, limits, true)?;
        let (phi, b) = (&mut bench.phi, &mut bench.geometry.b);
        (bench.system).constraints(t, q, phi, &mut Discard, b);
        Ok(closed)
    }

    /// Moves v onto the velocity rows where q was closed.
    pub(crate) fn project(&mut self, b: &SVector<f64, R>, v: &mut SVector<f64, N>) {
        let mut kappa = SVector::zeros();
        // The factors are those of a nearby pose.
        for _ in 0..2 {
            self.correct(b, v, &mut kappa);
        }
    }

    /// How independent the first `rows` rows are where it was placed, each of those that are eliminated before it.
    pub(crate) fn rank_margin(&self, rows: usize) -> RankMargin {
        self.matrix.rank_margin(self.plan, rows)
    }

    /// Whether rows are left out.
    pub(crate) fn leaves_rows_out(&self) -> bool {
        self.plan.redundant > 0
    }

    /// The weight of each row in the combination that is nearest to dependence.
    #[cold]
    pub(crate) fn weakest_rows(&mut self) -> SVector<f64, R> {
        self.matrix.combination(self.plan, &mut self.x)
    }
}

/// The position rows about the end of a step.
struct Near<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    planned: &'a mut Planned<N, R>,
    bench: &'a mut Bench<S, Q, N, R>,
    scale: &'a RowScale<R>,
    t: f64,
    q: &'a mut SVector<f64, Q>,
    is_evaluated: bool,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Closing
    for Near<'_, S, Q, N, R>
{
    /// The factors of where q was first are nearly those of where it is closed.
    const PATIENCE: i32 = 3;

    fn residual(&mut self) -> Result<f64, Fault> {
        if !std::mem::take(&mut self.is_evaluated) {
            self.planned.evaluate(self.bench, self.t, self.q);
        }
        Ok(residual_of(&self.bench.phi, &self.scale.weights))
    }

    fn factor(&mut self) -> Result<bool, Fault> {
        self.planned.factor(&mut self.bench.counters);
        Ok(self.planned.is_sound())
    }

    fn solve(&mut self) -> bool {
        let way = self.planned.displacement(&self.bench.phi);
        *self.q = self.bench.system.advance(self.q, &way, 1.0);
        false
    }

    fn enough(&self) -> f64 {
        match self.planned.rows {
            Rows::Independent => 1.0,
            _ => EXACT,
        }
    }

    fn round_off(&self) -> f64 {
        self.scale.lost
    }

    fn fault(&self, iterations: usize) -> Fault {
        not_converged(&self.bench.phi, &self.scale.weights, iterations)
    }
}
