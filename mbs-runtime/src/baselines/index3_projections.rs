//! The augmented Lagrangian of index 3 with projections, by the trapezoidal rule.
//!
//! ```text
//! M v̇ + Γvv = f + Aᵀ(λ − αφ),    λ ← λ − αφ in each iteration
//! θ = h/2 (v₀ + v₁),   v₁ = v₀ + h/2 (v̇₀ + v̇₁)
//! (W + h²/4 AᵀαA) v = W v* − h²/4 Aᵀα b,    (W + h²/4 AᵀαA) v̇ = W v̇* − h²/4 Aᵀα γ
//! ```
//!
//! with W = M + h/2 C + h²/4 K. Newton's method finds positions, and v* and v̇* with them, that satisfy the position
//! rows alone; the projections then remove from v* and v̇* what violates the rows of velocity and acceleration (Bayo &
//! Ledesma, Nonlinear Dyn. 9, 1996, 113–130; Cuadrado, Cardenal, Bayo, Multibody Syst. Dyn. 1, 1997, 259–280; Cuadrado,
//! Cardenal, Morer, Bayo, Multibody Syst. Dyn. 4, 2000, 55–73). In the literature α is a number that depends on the
//! step; here it is ξ m̄ · 4/h², so that ξ is the ratio of the rows to the masses in the matrix. The multipliers that are
//! reported are those of the projected v̇.

use super::bench::Bench;
use super::index1::Index1;
use super::motion::{Motion, Progress, consistent, move_rows};
use super::rule::{AnyRule, Rule};
use crate::ProjectionSettings;
use crate::fault::Fault;
use crate::flow::pull_back;
use crate::linear::{Pivoted, RowMatrix, accumulate, dot, scaled, vector};
use crate::sink::Discard;
use crate::{Method, Settings, System};
use nalgebra::SVector;

#[derive(Clone)]
pub(crate) struct Index3<const N: usize, const R: usize> {
    penalty: f64,
    motion: Motion<N>,
    factors: Box<Pivoted<N>>,
    moved: RowMatrix<N, R>,
    equations: Index1<N, R>,
    history: Option<History<N, R>>,
}

/// What is known where the state is.
#[derive(Clone, Copy)]
struct History<const N: usize, const R: usize> {
    acceleration: SVector<f64, N>,
    lambda: SVector<f64, R>,
    /// λ of the works: that of index 3 is of first order.
    consistent: SVector<f64, R>,
}

impl<const N: usize, const R: usize> Index3<N, R> {
    /// For the method of the settings.
    pub(crate) fn rule<S: System<Q, N, R>, const Q: usize>(
        _: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        let Method::Index3Projections(projections) = &settings.method else {
            return None;
        };
        Some(Ok(Box::new(Index3::new(projections))))
    }

    fn new(settings: &ProjectionSettings) -> Self {
        Index3 {
            penalty: settings.penalty,
            motion: Motion::new(),
            factors: Box::new(Pivoted::new()),
            moved: RowMatrix::zeros(),
            equations: Index1::new(0.0),
            history: None,
        }
    }

    fn refresh(&mut self) {
        self.history = None;
    }

    fn step<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        let old = match self.history {
            Some(history) => history,
            None => {
                let (acceleration, lambda) = consistent(&mut self.equations, bench)?;
                History {
                    acceleration,
                    lambda,
                    consistent: lambda,
                }
            }
        };
        let before = old.acceleration;
        bench.settle()?;
        // ξ m̄, that is h²/4 α.
        let lengths = bench.geometry.lengths_squared();
        let weights = vector(|i| self.penalty / lengths[i].max(f64::MIN_POSITIVE));
        let quarter = 0.25 * h * h;
        let (q0, v0, t0) = (
            bench.state.positions,
            bench.state.velocities,
            bench.state.time,
        );
        let t1 = t0 + h;

        let (mut after, mut lambda) = (before, old.lambda);
        let mut progress = Progress::new();
        let (q, mut v, applied) = loop {
            let v: SVector<f64, N> = vector(|i| v0[i] + 0.5 * h * (before[i] + after[i]));
            let turn: SVector<f64, N> = vector(|i| 0.5 * h * (v0[i] + v[i]));
            let q = bench.system.advance(&q0, &turn, 1.0);
            let Bench {
                system,
                geometry,
                phi,
                ..
            } = &mut *bench;
            system.constraints(t1, &q, phi, geometry.a.entries_mut(), &mut geometry.b);
            self.motion.balance(system, t1, &q, &v);
            self.motion.tangents(system, t1, &q, &v);
            let mut change = self.motion.defect(&v, &after);
            let penalties: SVector<f64, R> = vector(|i| -weights[i] / quarter * phi[i]);
            if progress.count() > 0 {
                for i in 0..R {
                    lambda[i] += penalties[i];
                }
            }
            let force: SVector<f64, R> = vector(|i| lambda[i] + penalties[i]);
            accumulate(&mut change, &geometry.a, &force);
            if !S::ROTATIONS.is_empty() {
                pull_back::<S, Q, N, R>(&turn, &mut self.motion.f_q);
            }
            self.motion.combine(0.5 * h, quarter);
            move_rows::<S, Q, N, R>(&geometry.a, &turn, &mut self.moved);
            for r in 0..R {
                for i in 0..N {
                    let left = weights[r] * geometry.a[r][i];
                    if left == 0.0 {
                        continue;
                    }
                    for j in 0..N {
                        self.motion.jacobian[i][j] += left * self.moved[r][j];
                    }
                }
            }
            if !self.factors.factor(&self.motion.jacobian) {
                return Err(progress.lost());
            }
            self.factors.solve(&mut change);
            for i in 0..N {
                after[i] += change[i];
            }
            let step = scaled(0.5 * h, &change);
            let (sizes, floor) = Progress::sizes(bench, &step, (&q, &v), h);
            if progress.settles(sizes, floor, bench.max_iterations)? {
                // With these multipliers `after` balances the forces.
                let applied: SVector<f64, R> =
                    vector(|i| force[i] - weights[i] * dot(&self.moved[i], &change));
                break (q, v, applied);
            }
        };
        bench.counters.iterations += progress.count();
        bench.counters.stages += 1;

        let Bench {
            system, geometry, ..
        } = &mut *bench;
        let rates: SVector<f64, R> = geometry.velocity_rows(system, &v);
        self.project(&geometry.a, &weights, &rates, &mut v);
        let mut gamma: SVector<f64, R> = SVector::zeros();
        system.constraint_rates(t1, &q, &v, &mut Discard, &mut gamma);
        for i in 0..R {
            gamma[i] += dot(&geometry.a[i], &after);
        }
        let unprojected = after;
        self.project(&geometry.a, &weights, &gamma, &mut after);
        // The round-off of φ is in λ, 4ξm̄/h² times. The projection removes it from v̇, with these multipliers in W v̇ = W v̇* + Aᵀκ.
        let moved: SVector<f64, N> = vector(|i| after[i] - unprojected[i]);
        let multipliers =
            vector(|i| applied[i] - weights[i] * (gamma[i] + dot(&self.moved[i], &moved)));

        bench.commit(t1, q, v, false)?;
        let consistent = if S::STRUCTURE.rheonomic {
            consistent(&mut self.equations, bench)?.1
        } else {
            lambda
        };
        let forces = [&old.consistent, &consistent];
        bench.multipliers = Some(multipliers);
        bench.trapezoid_works(t0, h, (&q0, &v0), (&q, &v), forces);
        self.history = Some(History {
            acceleration: after,
            lambda,
            consistent,
        });
        Ok(())
    }

    /// x ← x − (W + h²/4 AᵀαA)⁻¹ h²/4 Aᵀα · violation.
    fn project(
        &self,
        a: &RowMatrix<N, R>,
        weights: &SVector<f64, R>,
        violation: &SVector<f64, R>,
        x: &mut SVector<f64, N>,
    ) {
        let mut change = SVector::zeros();
        let forces = vector(|i| -weights[i] * violation[i]);
        accumulate(&mut change, a, &forces);
        self.factors.solve(&mut change);
        for i in 0..N {
            x[i] += change[i];
        }
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Index3<N, R>
{
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        Index3::step(self, bench, h)
    }

    fn refresh(&mut self) {
        Index3::refresh(self);
    }
}
