//! RATTLE, plain: a symplectic flow between two kicks along the rows, with Newton's method and no regularisation.
//!
//! ```text
//! M v_a = M v₀ + A₀ᵀκ₁,   (q₁, v_b) = Φ_h(q₀, v_a),   φ(q₁) = 0
//! M v₁ = M v_b + A₁ᵀκ₂,   A₁ v₁ + b₁ = 0
//! ```
//!
//! Andersen, J. Comput. Phys. 52, 1983, 24–34; Leimkuhler & Skeel, J. Comput. Phys. 112, 1994, 117–125. Φ is leapfrog
//! where M is constant (with free flight of turning bodies), the implicit midpoint elsewhere. Both matrices are
//! factored by plain elimination, which fails with dependent rows and at singular poses.

use super::bench::Bench;
use super::rule::{AnyRule, Rule};
use crate::alf3f::closing::{self, Closing, Limits};
use crate::alf3f::{not_converged, residual_of};
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::flow::{KickFlow, Leapfrog, Midpoint};
use crate::linear::{Pivoted, RowMatrix, accumulate, negative, scaled, vector};
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{Method, Settings, System};
use nalgebra::SVector;

#[derive(Clone)]
pub(crate) struct Rattle<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    flow: Stepping<Q, N, R>,
    rows: Rows<S, Q, N, R>,
}

#[derive(Clone)]
enum Stepping<const Q: usize, const N: usize, const R: usize> {
    Leapfrog(Box<Leapfrog<Q, N, R>>),
    Midpoint(Box<Midpoint<Q, N, R>>),
}

/// All but the flow.
#[derive(Clone)]
struct Rows<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    end: Box<ConstraintGeometry<S, Q, N, R>>,
    matrix: RowMatrix<R, R>,
    factors: Box<Pivoted<R>>,
    scale: Box<RowScale<R>>,
    /// κ₁/h of the last step.
    force: SVector<f64, R>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rattle<S, Q, N, R> {
    /// For the method of the settings.
    pub(crate) fn rule(
        bench: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        if settings.method != Method::Rattle {
            return None;
        }
        let rattle = Self::new(
            &bench.system,
            &bench.state.positions,
            &bench.yardstick,
            settings,
        );
        Some(rattle.map(|rattle| -> AnyRule<S, Q, N, R> { Box::new(rattle) }))
    }

    fn new(
        system: &S,
        q: &SVector<f64, Q>,
        yardstick: &Yardstick<Q, N>,
        settings: &Settings,
    ) -> Result<Self, Fault> {
        Ok(Rattle {
            flow: if S::STRUCTURE.constant_mass {
                Stepping::Leapfrog(Box::new(Leapfrog::new::<S>()))
            } else {
                Stepping::Midpoint(Midpoint::new(yardstick, false))
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

    fn refresh(&mut self) {
        self.rows.force = SVector::zeros();
    }

    fn step(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
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
        let t1 = bench.state.time + h;
        let kappa = scaled(h, &self.force);
        let mut va = bench.state.velocities;
        accumulate(&mut va, &bench.geometry.w, &kappa);
        let (t0, q) = (bench.state.time, bench.state.positions);
        let power = (bench.system).nonconservative_power(t0, &q, &bench.state.velocities);
        flow.begin(
            &bench.system,
            [t0, t1],
            &q,
            [&bench.state.velocities, &va],
            &bench.geometry,
            h,
        );
        let limits = Limits {
            most: bench.max_iterations,
            fixed: None,
        };
        let mut ends = Ends {
            bench: &mut *bench,
            flow: &mut *flow,
            rows: self,
            t1,
            h,
            kappa,
            va,
            q,
        };
        let closed = closing::close(&mut ends, limits, false);
        let Ends { kappa, va, q, .. } = ends;
        let iterations = match closed {
            Ok(closed) => closed.map_or(0, |closed| closed.iterations),
            Err(fault) => {
                self.force = SVector::zeros();
                return Err(fault);
            }
        };
        let Bench {
            system,
            geometry: start,
            counters,
            ..
        } = bench;
        counters.iterations += iterations as u64;
        counters.stages += 1;
        let end = &mut self.end;
        end.metric(system, t1, &q)?;
        let mut v = flow.velocities(system, &va, &q, end);
        let mut multiplier = negative(&end.velocity_rows(system, &v));
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
        self.force = vector(|i| kappa[i] / h);
        bench.multipliers = Some(vector(|i| (kappa[i] + multiplier[i]) / h));
        std::mem::swap(start, end);
        let power = power + bench.system.nonconservative_power(t1, &q, &v);
        bench.add_works(0.5 * h, [power, 0.0]);
        bench.works.drive += drive;
        bench.commit(t1, q, v, true)
    }
}

/// The position rows at the end of a step, as functions of its first kick.
struct Ends<'a, S, F, const Q: usize, const N: usize, const R: usize>
where
    S: System<Q, N, R>,
{
    bench: &'a mut Bench<S, Q, N, R>,
    flow: &'a mut F,
    rows: &'a mut Rows<S, Q, N, R>,
    t1: f64,
    h: f64,
    kappa: SVector<f64, R>,
    va: SVector<f64, N>,
    q: SVector<f64, Q>,
}

impl<S, F, const Q: usize, const N: usize, const R: usize> Closing for Ends<'_, S, F, Q, N, R>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    /// Plain Newton.
    const PATIENCE: i32 = 0;

    #[inline(always)]
    fn residual(&mut self) -> Result<f64, Fault> {
        let Bench { system, phi, .. } = &mut *self.bench;
        let Rows { end, scale, .. } = &mut *self.rows;
        self.flow.positions(system, &self.va, &mut self.q)?;
        system.constraints(self.t1, &self.q, phi, end.a.entries_mut(), &mut end.b);
        Ok(residual_of(phi, &scale.weights))
    }

    #[inline(always)]
    fn factor(&mut self) -> Result<bool, Fault> {
        let Bench {
            system, geometry, ..
        } = &mut *self.bench;
        let directions = self.flow.position_sensitivity(system, &self.va, geometry)?;
        system.delassus(&self.rows.end.a, directions, &mut self.rows.matrix);
        match self.rows.factors.factor(&self.rows.matrix) {
            true => Ok(true),
            false => Err(self.fault(0)),
        }
    }

    #[inline(always)]
    fn solve(&mut self) -> bool {
        let mut change = vector(|i| -self.bench.phi[i] / self.h);
        self.rows.factors.solve(&mut change);
        self.kappa += change;
        accumulate(&mut self.va, &self.bench.geometry.w, &change);
        self.flow.predict(&change);
        false
    }

    fn round_off(&self) -> f64 {
        let of_positions = self.bench.yardstick.round_off_of_positions(&self.q);
        self.rows.scale.round_off_at(of_positions, false)
    }

    #[inline(always)]
    fn fault(&self, iterations: usize) -> Fault {
        not_converged(&self.bench.phi, &self.rows.scale.weights, iterations)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Rattle<S, Q, N, R>
{
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        Rattle::step(self, bench, h)
    }

    fn refresh(&mut self) {
        Rattle::refresh(self);
    }
}
