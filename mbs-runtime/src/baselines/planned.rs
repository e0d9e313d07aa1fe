//! Accelerations and projections of large mechanisms by the elimination that was planned when they were compiled:
//! operations in proportion to the length of a chain.
//!
//! ```text
//! [ M  Aᵀ ] [ v̇  ]   [ F − ṗ|_v ]
//! [ A  0  ] [ −λ ] = [ −γ − …   ]
//! ```
//!
//! Where rows are nearly dependent the dense equations take over, which have a proximal solve.

use super::bench::Bench;
use crate::System;
use crate::alf3f::closing::{self, Closed, Closing, Limits};
use crate::alf3f::sparse::{Bordered, Rows, Slots};
use crate::alf3f::{not_converged, residual_of};
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
    /// A vector in the order of elimination.
    x: Slots,
    rows: Rows,
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
        // Where the rows that are kept lose a direction, those that are left out may still have it: dense arrays find out.
        let thresholds = match plan.redundant {
            0 => Thresholds::ELIMINATED,
            _ => dense,
        };
        let (system, state) = (&bench.system, &bench.state);
        let mass = mass_rows(system, &state.positions);
        let mut planned = Box::new(Planned {
            plan,
            matrix: Bordered::new(plan, &mass, thresholds),
            x: vec![0.0; plan.unknowns].into_boxed_slice(),
            rows: Rows::Lost,
        });
        let entries = &mut planned.matrix.entries;
        let (mut phi, mut b) = (SVector::zeros(), SVector::zeros());
        system.sparse_constraints(state.time, &state.positions, &mut phi, entries, &mut b);
        planned.factor();
        if plan.redundant > 0 {
            if planned.matrix.left_out(plan) != plan.redundant {
                return None;
            }
            planned.matrix.free_dependent(plan);
            planned.rows = planned.matrix.rows(plan);
        }
        Some(planned)
    }

    fn factor(&mut self) {
        self.matrix.factor(self.plan);
        self.rows = self.matrix.rows(self.plan);
    }

    /// Whether solutions with the factor are those of the equations.
    pub(crate) fn is_sound(&self) -> bool {
        matches!(self.rows, Rows::Independent | Rows::Weak)
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
        self.factor();
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
        let rates = self.rates(v);
        let missing = vector(|i| -(rates[i] + demand[i]));
        (self.matrix).solve(self.plan, &missing, &mut self.x, (v, kappa));
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
        self.planned.factor();
        Ok(self.planned.is_sound())
    }

    fn solve(&mut self) -> bool {
        let Planned {
            plan, matrix, x, ..
        } = &mut *self.planned;
        let change = negative(&self.bench.phi);
        let mut way = SVector::zeros();
        matrix.solve(plan, &change, x, (&mut way, &mut SVector::zeros()));
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
