//! Rows as stiff springs and dampers: the penalty method.
//!
//! ```text
//! ṗ = F − Aᵀ(k φ + c (A v + b)),    k = ξ m̄,  c = 2 ζ √ξ m̄
//! ```
//!
//! with the effective mass m̄ = 1/(a M⁻¹aᵀ) of each row where the simulation starts, so that √ξ is its frequency and ζ
//! its damping ratio (Bayo, García de Jalón, Serna, Comput. Methods Appl. Mech. Eng. 71, 1988, 183–195, use the same
//! pair of numbers for every row). Nonholonomic rows have the damper alone, c = ξ m̄ · 1 s. Integrated by the implicit
//! trapezoidal rule in momentum form. The rows are violated in proportion to 1/ξ; redundant rows and singular poses
//! need no special treatment.

use super::bench::Bench;
use super::motion::{Motion, Progress, move_rows};
use super::rule::{AnyRule, Rule};
use crate::PenaltySettings;
use crate::fault::Fault;
use crate::flow::{pull_back, trapezoid};
use crate::linear::{Pivoted, RowMatrix, array, largest, scaled, vector};
use crate::row_scale::RowScale;
use crate::{Method, Settings, System};
use nalgebra::SVector;

#[derive(Clone)]
pub(crate) struct Penalty<const N: usize, const R: usize> {
    settings: PenaltySettings,
    scale: Box<RowScale<R>>,
    /// k and c of each row; none until a simulation starts.
    rows: Option<[[f64; 2]; R]>,
    motion: Motion<N>,
    factors: Box<Pivoted<N>>,
    moved: RowMatrix<N, R>,
}

impl<const N: usize, const R: usize> Penalty<N, R> {
    /// For the method of the settings.
    pub(crate) fn rule<S: System<Q, N, R>, const Q: usize>(
        bench: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        let Method::Penalty(penalty) = settings.method else {
            return None;
        };
        let scale = RowScale::new(&bench.system, &bench.yardstick, settings);
        Some(scale.map(|scale| -> AnyRule<S, Q, N, R> { Box::new(Penalty::new(penalty, scale)) }))
    }

    fn new(settings: PenaltySettings, scale: RowScale<R>) -> Self {
        Penalty {
            settings,
            scale: Box::new(scale),
            rows: None,
            motion: Motion::new(),
            factors: Box::new(Pivoted::new()),
            moved: RowMatrix::zeros(),
        }
    }

    fn stiffness<S: System<Q, N, R>, const Q: usize>(
        &self,
        bench: &Bench<S, Q, N, R>,
    ) -> [[f64; 2]; R] {
        let PenaltySettings {
            penalty,
            damping_ratio,
        } = self.settings;
        let lengths = bench.geometry.lengths_squared();
        let rows = &self.scale.lengths_squared;
        // A row that is zero at the start gets the stiffness of the longest row, in comparable units.
        let longest = largest(&vector::<R>(|i| lengths[i] / rows[i]));
        array(|i| {
            let longest = (longest * rows[i]).max(f64::MIN_POSITIVE);
            let length = if lengths[i] > 1e-8 * longest {
                lengths[i]
            } else {
                longest
            };
            if i < S::STRUCTURE.holonomic_rows {
                [
                    penalty / length,
                    2.0 * damping_ratio * penalty.sqrt() / length,
                ]
            } else {
                [0.0, penalty / length]
            }
        })
    }

    fn step<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        bench.settle()?;
        let rows = match self.rows {
            Some(rows) => rows,
            None => self.stiffness(bench),
        };
        self.rows = Some(rows);
        let (q0, v0, t0) = (
            bench.state.positions,
            bench.state.velocities,
            bench.state.time,
        );
        let t1 = t0 + h;
        self.motion.balance(&bench.system, t0, &q0, &v0);
        let start = forces(bench, &rows, &v0);
        let mut known: SVector<f64, N> = vector(|i| self.motion.p[i] + 0.5 * h * self.motion.f[i]);
        pull(&mut known, bench, 0.5 * h, &start);

        let mut v = v0;
        let mut progress = Progress::new();
        let q = loop {
            let q = trapezoid(&bench.system, &q0, &v0, &v, h);
            let Bench {
                system,
                geometry,
                phi,
                ..
            } = &mut *bench;
            system.constraints(t1, &q, phi, geometry.a.entries_mut(), &mut geometry.b);
            self.motion.balance(system, t1, &q, &v);
            self.motion.tangents(system, t1, &q, &v);
            let force = forces(bench, &rows, &v);
            let mut change: SVector<f64, N> =
                vector(|i| known[i] - self.motion.p[i] + 0.5 * h * self.motion.f[i]);
            pull(&mut change, bench, 0.5 * h, &force);
            self.jacobian(bench, &rows, &v0, &v, h);
            if !self.factors.factor(&self.motion.jacobian) {
                return Err(progress.lost());
            }
            self.factors.solve(&mut change);
            for i in 0..N {
                v[i] += change[i];
            }
            let (sizes, floor) = Progress::sizes(bench, &change, (&q, &v), h);
            if progress.settles(sizes, floor, bench.max_iterations)? {
                break q;
            }
        };
        bench.counters.iterations += progress.count();
        bench.counters.stages += 1;
        let end = forces(bench, &rows, &v);
        bench.multipliers = Some(end);
        bench.trapezoid_works(t0, h, (&q0, &v0), (&q, &v), [&start, &end]);
        bench.commit(t1, q, v, false)
    }

    /// J = M + h/2 (∂p/∂q − h/2 ∂F/∂q) T − h/2 ∂F/∂v + h/2 Aᵀ(c + h/2 k T) A.
    fn jacobian<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
        rows: &[[f64; 2]; R],
        v0: &SVector<f64, N>,
        v1: &SVector<f64, N>,
        h: f64,
    ) {
        let turn: SVector<f64, N> = vector(|i| 0.5 * h * (v0[i] + v1[i]));
        let motion = &mut self.motion;
        if !S::ROTATIONS.is_empty() {
            pull_back::<S, Q, N, R>(&turn, &mut motion.f_q);
            pull_back::<S, Q, N, R>(&turn, &mut motion.p_q);
        }
        motion.combine(0.5 * h, 0.25 * h * h);
        let a = &bench.geometry.a;
        move_rows::<S, Q, N, R>(a, &turn, &mut self.moved);
        for (r, [k, c]) in rows.iter().enumerate() {
            for i in 0..N {
                let left = 0.5 * h * a[r][i];
                if left == 0.0 {
                    continue;
                }
                for j in 0..N {
                    motion.jacobian[i][j] += left * (c * a[r][j] + 0.5 * h * k * self.moved[r][j]);
                }
            }
        }
    }
}

/// −(k φ + c (A v + b)) at the state of the bench; these values correspond to multipliers.
fn forces<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    bench: &Bench<S, Q, N, R>,
    rows: &[[f64; 2]; R],
    v: &SVector<f64, N>,
) -> SVector<f64, R> {
    let rates = bench.geometry.velocity_rows(&bench.system, v);
    vector(|i| -rows[i][0] * bench.phi[i] - rows[i][1] * rates[i])
}

/// x ← x + weight Aᵀ force.
fn pull<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    x: &mut SVector<f64, N>,
    bench: &Bench<S, Q, N, R>,
    weight: f64,
    force: &SVector<f64, R>,
) {
    crate::linear::accumulate(x, &bench.geometry.a, &scaled(weight, force));
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Penalty<N, R>
{
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        Penalty::step(self, bench, h)
    }
}
