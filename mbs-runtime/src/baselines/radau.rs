//! Radau IIA of three stages and order 5 on both levels of the rows (Hairer, Wanner: Solving Ordinary Differential Equations
//! II, sections IV.8 and VII.4): implicit steps for forces of velocity, stiff ones above all.
//!
//! ```text
//! p(Q_i, V_i) = p₀ + h Σ_j a_ij (F_j + A_jᵀ λ_j),   Q_i = q₀ ⊕ h Σ_j a_ij T(θ_j)⁻¹ V_j,   A_i V_i + b_i = 0
//! ```
//!
//! The last stage is the end of the step; it is [projected](super::projection) onto the position rows, which the stages do not
//! have. Newton's corrections are those of one real and one complex system, of the size of the mechanism: the basis in which
//! (a_ij) is diagonal. They neglect how A and p change along a step, so that they converge with the way of a step as their
//! rate; factors are kept from step to step while they converge fast.

use super::bench::Bench;
use super::complex_saddle::ComplexSaddle;
use super::index1::Index1;
use super::motion::{Motion, Progress};
use super::radau_coefficients::{COMPLEX, FROM_BASIS, INTO_BASIS, NODES, REAL, WEIGHTS};
use super::rule::{AnyRule, Rule};
use super::saddle::Saddle;
use crate::fault::Fault;
use crate::flow::unroll;
use crate::linear::{RowMatrix, accumulate, add_scaled, dot, vector, zeros};
use crate::row_scale::RowScale;
use crate::singular::RankMargin;
use crate::{Method, Settings, System};
use nalgebra::{Complex, SVector};

/// Factors are kept after steps of so few corrections.
const FEW: u64 = 5;
/// Factors serve for steps whose lengths differ by this part.
const EQUAL: f64 = 1e-9;
/// Corrections that do not shrink to this fraction end in new factors.
const SLOW: f64 = 0.3;
/// Corrections end at this part of the error of the step. The polynomial of the last step, with which they begin, is wrong by
/// h⁴, and the step by h⁶: by the power 3/2 of what the first correction takes back.
const LOOSE: f64 = 1e-4;
/// … of the speed, and at this one at most: where a stiff force has just begun to act, the prediction tells nothing.
const LOOSEST: f64 = 1e-6;
/// Rates of change of θ, from one correction to the next: each evaluation shrinks their error by the angle of a step.
const TURNS: usize = 3;

#[derive(Clone)]
pub(crate) struct Radau<const Q: usize, const N: usize, const R: usize> {
    motion: Motion<N>,
    /// A where the factors were made.
    a: RowMatrix<N, R>,
    saddle: Saddle<N, R>,
    complex: ComplexSaddle<N, R>,
    /// The step for which there are factors, s; zero: for none.
    factored: f64,
    /// The rows at the end of the step, …
    equations: Index1<N, R>,
    /// … and whether they are factored at the current state.
    placed: bool,
    scale: Box<RowScale<R>>,
    stages: Box<[Stage<Q, N, R>; 3]>,
    /// The length of the step that the stages belong to, s; zero: there was none.
    length: f64,
    /// The velocities at its beginning.
    before: SVector<f64, N>,
}

#[derive(Clone, Copy)]
struct Stage<const Q: usize, const N: usize, const R: usize> {
    q: SVector<f64, Q>,
    v: SVector<f64, N>,
    lambda: SVector<f64, R>,
    /// θ.
    turn: SVector<f64, N>,
    p: SVector<f64, N>,
    /// F + Aᵀλ.
    force: SVector<f64, N>,
    /// A v + b.
    rates: SVector<f64, R>,
    /// −λ · b, W.
    drive: f64,
}

impl<const Q: usize, const N: usize, const R: usize> Radau<Q, N, R> {
    /// For the method of the settings.
    pub(crate) fn rule<S: System<Q, N, R>>(
        bench: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        if settings.method != Method::Radau {
            return None;
        }
        let make = || -> Result<AnyRule<S, Q, N, R>, Fault> {
            let scale = Box::new(RowScale::new(&bench.system, &bench.yardstick, settings)?);
            let stage = Stage {
                q: bench.state.positions,
                v: bench.state.velocities,
                lambda: zeros(),
                turn: zeros(),
                p: zeros(),
                force: zeros(),
                rates: zeros(),
                drive: 0.0,
            };
            Ok(Box::new(Radau {
                motion: Motion::new(),
                a: RowMatrix::zeros(),
                saddle: Saddle::new(),
                complex: ComplexSaddle::new(),
                factored: 0.0,
                equations: Index1::detecting_densely(bench, scale.final_lengths())?,
                placed: false,
                scale,
                stages: Box::new([stage; 3]),
                length: 0.0,
                before: zeros(),
            }))
        };
        Some(make())
    }

    fn step<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        self.placed = false;
        let known = (self.length != 0.0).then_some(*self.stages);
        if !((self.factored - h).abs() <= EQUAL * h.abs()) {
            self.factored = 0.0;
        }
        let mut corrections = self.attempt(bench, h, known.as_ref());
        if known.is_some() && corrections.is_err() {
            self.factored = 0.0;
            corrections = self.attempt(bench, h, None);
        }
        if corrections.is_err() {
            (self.length, self.factored) = (0.0, 0.0);
        }
        let corrections = corrections?;
        if corrections > FEW {
            self.factored = 0.0;
        }
        bench.counters.iterations += corrections;
        bench.counters.stages += NODES.len() as u64;
        self.end(bench, h)
    }

    /// The stages of a step of h; returns the number of corrections. `known`: those of the last step.
    fn attempt<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
        known: Option<&[Stage<Q, N, R>; 3]>,
    ) -> Result<u64, Fault> {
        let (q0, v0) = (bench.state.positions, bench.state.velocities);
        let mut p0 = zeros();
        bench.system.momentum(&q0, &v0, &mut p0);
        for (i, stage) in self.stages.iter_mut().enumerate() {
            stage.v = match known {
                Some(last) => extrapolated(&self.before, last, 1.0 + NODES[i] * h / self.length),
                None => v0,
            };
            stage.lambda = known.map_or(zeros(), |last| last[2].lambda);
            stage.turn = vector(|k| h * NODES[i] * v0[k]);
        }
        let mut progress = Progress::new();
        let (mut last, mut enough) = (f64::INFINITY, 0.0);
        loop {
            self.evaluate(bench, h);
            let fresh = self.factored == 0.0;
            if fresh && !self.factor(bench, h) {
                return Err(progress.lost());
            }
            let change = self.correct(&p0, h);
            let size = bench.yardstick.measure(&change);
            let end = &self.stages[2];
            let (sizes, floor) = Progress::sizes(bench, &change, (&end.q, &end.v), h);
            if last.is_infinite() && known.is_some() {
                let [size, speed] = sizes;
                enough = (LOOSE * (size / speed).powf(1.5)).min(LOOSEST);
            }
            if progress.will_settle(sizes, (floor, enough), bench.max_iterations)? {
                return Ok(progress.count());
            }
            if size > SLOW * last {
                if fresh && !(size < last) {
                    return Err(progress.lost());
                }
                self.factored = 0.0;
            }
            last = size;
        }
    }

    /// Factors both systems at the second stage, as the one in the middle, which was evaluated last; false if one is singular or not finite.
    fn factor<S: System<Q, N, R>>(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> bool {
        let t = bench.state.time + NODES[1] * h;
        let Stage { q, v, .. } = self.stages[1];
        let motion = &mut self.motion;
        motion.tangents(&bench.system, t, &q, &v);
        self.a.overwrite(&bench.geometry.a);
        motion.combine(h * REAL, h * REAL * h * REAL);
        self.factored = 0.0;
        if !self.saddle.factor(&motion.jacobian, &self.a, &self.a) {
            return false;
        }
        let of = h * COMPLEX;
        let (mass, p_q, f_v, f_q) = (&motion.mass, &motion.p_q, &motion.f_v, &motion.f_q);
        let entry = |i: usize, j: usize| {
            Complex::from(mass[i][j]) + of * (p_q[i][j] - f_v[i][j]) - of * of * f_q[i][j]
        };
        if !self.complex.factor(entry, &self.a, &self.saddle) {
            return false;
        }
        self.factored = h;
        true
    }

    /// The equations at the stages.
    fn evaluate<S: System<Q, N, R>>(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) {
        let (t0, q0) = (bench.state.time, bench.state.positions);
        let stages = &mut *self.stages;
        for _ in 0..if S::ROTATIONS.is_empty() { 1 } else { TURNS } {
            let rates = stages.map(|stage| {
                let mut rate = stage.v;
                unroll::<S, Q, N, R>(&stage.turn, &mut rate);
                rate
            });
            for (stage, weights) in stages.iter_mut().zip(&WEIGHTS) {
                stage.turn = weighted(h, weights, &rates);
            }
        }
        // The second one last: there the factors are made.
        for i in [0, 2, 1] {
            let (stage, t) = (&mut stages[i], t0 + NODES[i] * h);
            stage.q = bench.system.advance(&q0, &stage.turn, 1.0);
            let Bench {
                system,
                geometry,
                phi,
                ..
            } = &mut *bench;
            system.balance(t, &stage.q, &stage.v, &mut stage.p, &mut stage.force);
            system.constraints(t, &stage.q, phi, geometry.a.entries_mut(), &mut geometry.b);
            accumulate(&mut stage.force, &geometry.a, &stage.lambda);
            stage.rates = vector(|i| dot(&geometry.a[i], &stage.v) + geometry.b[i]);
            stage.drive = -dot(&stage.lambda, &geometry.b);
        }
    }

    /// One correction of the stages; returns that of the end.
    fn correct(&mut self, p0: &SVector<f64, N>, h: f64) -> SVector<f64, N> {
        let stages = &mut *self.stages;
        let forces = stages.map(|stage| stage.force);
        let missing: [SVector<f64, N>; 3] = std::array::from_fn(|i| {
            let impulse = weighted(h, &WEIGHTS[i], &forces);
            vector(|k| p0[k] + impulse[k] - stages[i].p[k])
        });
        let open = stages.map(|stage| -stage.rates);
        let mut x: SVector<f64, N> = weighted(1.0, &INTO_BASIS[0], &missing);
        let mut mu: SVector<f64, R> = weighted(1.0, &INTO_BASIS[0], &open);
        self.saddle.solve(&mut x, &mut mu, &self.a);
        let [re, im] = [1, 2].map(|k| weighted::<N>(1.0, &INTO_BASIS[k], &missing));
        let mut z: [Complex<f64>; N] = std::array::from_fn(|i| Complex::new(re[i], im[i]));
        let [re, im] = [1, 2].map(|k| weighted::<R>(1.0, &INTO_BASIS[k], &open));
        let mut nu: [Complex<f64>; R] = std::array::from_fn(|i| Complex::new(re[i], im[i]));
        self.complex.solve(&mut z, &mut nu, &self.saddle);
        // μ = h a λ in this basis.
        let (real, complex) = (1.0 / (h * REAL), 1.0 / (h * COMPLEX));
        let mut change = zeros();
        for (stage, [a, b, c]) in stages.iter_mut().zip(FROM_BASIS) {
            change = vector(|k| a * x[k] + b * z[k].re + c * z[k].im);
            add_scaled(&mut stage.v, 1.0, &change);
            for k in 0..R {
                let nu = nu[k] * complex;
                stage.lambda[k] += a * mu[k] * real + b * nu.re + c * nu.im;
            }
        }
        change
    }

    /// Works of the step, and its end on the rows.
    fn end<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        let t0 = bench.state.time;
        for ((stage, node), weight) in self.stages.iter().zip(NODES).zip(WEIGHTS[2]) {
            let t = t0 + node * h;
            let applied = (bench.system).nonconservative_power(t, &stage.q, &stage.v);
            bench.add_works(h * weight, [applied, stage.drive]);
        }
        let Stage {
            mut q,
            mut v,
            lambda,
            ..
        } = self.stages[2];
        (self.length, self.before) = (h, bench.state.velocities);
        bench.multipliers = Some(lambda);
        let t1 = t0 + h;
        if R > 0 {
            self.equations.begin();
            self.equations.close(bench, t1, &mut q, &self.scale)?;
            self.equations.project(bench, &mut v);
        }
        bench.commit(t1, q, v, R > 0)?;
        self.placed = R > 0;
        Ok(())
    }
}

/// h Σ c_j x_j.
fn weighted<const K: usize>(
    h: f64,
    coefficients: &[f64; 3],
    x: &[SVector<f64, K>; 3],
) -> SVector<f64, K> {
    let [a, b, c] = coefficients.map(|coefficient| h * coefficient);
    vector(|k| a * x[0][k] + b * x[1][k] + c * x[2][k])
}

/// The velocities of the last step, with those at its beginning, as a polynomial at a place of its length.
fn extrapolated<const Q: usize, const N: usize, const R: usize>(
    before: &SVector<f64, N>,
    last: &[Stage<Q, N, R>; 3],
    place: f64,
) -> SVector<f64, N> {
    let nodes = [0.0, NODES[0], NODES[1], NODES[2]];
    let weights: [f64; 4] = std::array::from_fn(|k| {
        let others = nodes.iter().enumerate().filter(|&(other, _)| other != k);
        let factors = others.map(|(_, node)| (place - node) / (nodes[k] - node));
        factors.product()
    });
    let [zero, a, b, c] = weights;
    let [first, second, third] = last;
    vector(|k| zero * before[k] + a * first.v[k] + b * second.v[k] + c * third.v[k])
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Radau<Q, N, R>
{
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        self.step(bench, h)
    }

    fn refresh(&mut self) {
        (self.length, self.factored) = (0.0, 0.0);
        self.placed = false;
    }

    fn rank_margin(&mut self, bench: &mut Bench<S, Q, N, R>) -> Option<RankMargin> {
        self.equations.margin_here(bench, &mut self.placed)
    }

    fn weakest_rows(&mut self, bench: &Bench<S, Q, N, R>) -> SVector<f64, R> {
        self.equations.weakest_rows(bench)
    }
}
