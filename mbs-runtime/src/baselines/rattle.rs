//! RATTLE, plain: a symplectic flow between two kicks along the rows, with Newton's method and no regularisation.
//!
//! ```text
//! M v_a = M v₀ + A₀ᵀκ₁,   (q₁, v_b) = Φ_h(q₀, v_a),   φ(q₁) = 0
//! M v₁ = M v_b + A₁ᵀκ₂,   A₁ v₁ + b₁ = 0
//! ```
//!
//! Andersen, J. Comput. Phys. 52, 1983, 24–34; Leimkuhler & Skeel, J. Comput. Phys. 112, 1994, 117–125. Φ is leapfrog where
//! M is constant (with free flight of turning bodies), the implicit midpoint elsewhere. Both matrices are factored by plain
//! elimination: dependent rows and singular poses are more than it can do.

use super::bench::Bench;
use crate::alf3f::{ConstraintGeometry, Fault, RowScale, not_converged, residual_of};
use crate::flow::{KickFlow, Leapfrog, Midpoint};
use crate::linear::{Pivoted, RowMatrix, accumulate};
use crate::yardstick::Yardstick;
use crate::{Settings, System};
use nalgebra::SVector;

/// A residual this many times above its tolerance (squared) is taken when it no longer improves: round-off.
const STAGNATED: f64 = 1e6;

pub(crate) struct Rattle<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    flow: Stepping<Q, N, R>,
    rows: Rows<S, Q, N, R>,
}

enum Stepping<const Q: usize, const N: usize, const R: usize> {
    Leapfrog(Box<Leapfrog<Q, N, R>>),
    Midpoint(Box<Midpoint<Q, N, R>>),
}

/// All but the flow.
struct Rows<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    end: Box<ConstraintGeometry<S, Q, N, R>>,
    matrix: RowMatrix<R, R>,
    factors: Box<Pivoted<R>>,
    scale: Box<RowScale<R>>,
    /// κ₁/h of the last step.
    force: SVector<f64, R>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rattle<S, Q, N, R> {
    pub(crate) fn new(
        system: &S,
        q: &SVector<f64, Q>,
        yardstick: &Yardstick<Q, N>,
        settings: &Settings,
    ) -> Result<Self, Fault> {
        Ok(Rattle {
            flow: if S::STRUCTURE.constant_mass {
                Stepping::Leapfrog(Box::new(Leapfrog::new::<S>()))
            } else {
                Stepping::Midpoint(Midpoint::new(yardstick))
            },
            rows: Rows {
                end: ConstraintGeometry::new(system, q)?,
                matrix: RowMatrix::zeros(),
                factors: Box::new(Pivoted::new()),
                scale: Box::new(RowScale::new(system, yardstick, settings)?),
                force: SVector::zeros(),
            },
        })
    }

    pub(crate) fn refresh(&mut self) {
        self.rows.force = SVector::zeros();
    }

    pub(crate) fn step(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        match &mut self.flow {
            Stepping::Leapfrog(flow) => self.rows.step(bench, &mut **flow, h),
            Stepping::Midpoint(flow) => self.rows.step(bench, &mut **flow, h),
        }
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rows<S, Q, N, R> {
    fn step<F: KickFlow<S, Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        flow: &mut F,
        h: f64,
    ) -> Result<(), Fault> {
        bench.settle()?;
        let Bench {
            system,
            state,
            geometry: start,
            phi,
            counters,
            ..
        } = bench;
        let t1 = state.time + h;
        let mut kappa = self.force.map(|force| h * force);
        let mut va = state.velocities;
        accumulate(&mut va, &start.w, &kappa);
        flow.begin(system, state.time, &state.positions, &va, start, h);
        let mut q = state.positions;
        let (mut last, mut iterations) = (f64::INFINITY, 0);
        loop {
            flow.positions(system, &va, &mut q)?;
            let end = &mut self.end;
            system.constraints(t1, &q, phi, &mut end.a, &mut end.b);
            let residual = residual_of(phi, &self.scale.weights);
            if residual <= 1.0 || (residual > 0.5 * last && residual < STAGNATED) {
                break;
            }
            let directions = flow.position_sensitivity(system, &va, start)?;
            system.delassus(&self.end.a, directions, &mut self.matrix);
            if iterations >= bench.max_iterations
                || !residual.is_finite()
                || !self.factors.factor(&self.matrix)
            {
                self.force = SVector::zeros();
                return Err(not_converged(phi, &self.scale.weights, iterations));
            }
            let mut change = phi.map(|residual| -residual / h);
            self.factors.solve(&mut change);
            for i in 0..R {
                kappa[i] += change[i];
            }
            accumulate(&mut va, &start.w, &change);
            flow.predict(&change);
            last = residual;
            iterations += 1;
        }
        counters.iterations += iterations as u64;
        counters.stages += 1;
        let end = &mut self.end;
        end.metric(system, t1, &q)?;
        let mut v = flow.velocities(system, &va, &q, end);
        let mut multiplier = end.velocity_rows(system, &v).map(|rate| -rate);
        if !self.factors.factor(&end.delassus) {
            self.force = SVector::zeros();
            return Err(not_converged(
                &multiplier,
                &SVector::repeat(1.0),
                iterations,
            ));
        }
        self.factors.solve(&mut multiplier);
        accumulate(&mut v, &end.w, &multiplier);
        let drive: f64 = (0..R)
            .map(|i| -kappa[i] * start.b[i] - multiplier[i] * end.b[i])
            .sum();
        self.force = kappa.map(|kappa| kappa / h);
        std::mem::swap(start, end);
        bench.works.drive += drive;
        bench.commit(t1, q, v, true)
    }
}
