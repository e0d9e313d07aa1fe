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
//!
//! With a tolerance each step has the estimate of its error by the embedded formula of order 3, IV.8 (8.19) there.

use super::bench::Bench;
use super::complex_saddle::ComplexSaddle;
use super::index1::Index1;
use super::motion::{Motion, Progress};
use super::radau_coefficients::{COMPLEX, EMBEDDED, FROM_BASIS, INTO_BASIS, NODES, REAL, WEIGHTS};
use super::radau_errors::Errors;
use super::radau_memory::{Known, Memory};
use super::rule::{AnyRule, Rule};
use super::saddle::Saddle;
use crate::estimate::Estimate;
use crate::fault::Fault;
use crate::flow::unroll;
use crate::linear::{RowMatrix, accumulate, add_scaled, dot, vector, zeros};
use crate::row_scale::RowScale;
use crate::singular::RankMargin;
use crate::sink::Discard;
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
/// … and at this part of a tolerance: the steps may use twenty times as much.
const TIGHT: f64 = 1e-3;
/// Without a prediction the first correction may move the end of a step so far, in sizes or radians: from farther away the rows
/// can be satisfied on another branch.
const NEARBY: f64 = 0.3;
/// Rates of change of θ, from one correction to the next: each evaluation shrinks their error by the angle of a step.
const TURNS: usize = 3;

#[derive(Clone)]
pub(crate) struct Radau<const Q: usize, const N: usize, const R: usize> {
    motion: Motion<N>,
    /// The factors in use, and those for steps of the last other length.
    factors: Box<[Factors<N, R>; 2]>,
    /// The rows at the end of the step, …
    equations: Index1<N, R>,
    /// … and whether they are factored at the current state.
    placed: bool,
    scale: Box<RowScale<R>>,
    stages: Box<[Stage<Q, N, R>; 3]>,
    memory: Memory<Q, N, R>,
    /// The part of the speed at which corrections may end, at most.
    loosest: f64,
    /// What the estimate of the error of the last step needs: with a tolerance.
    errors: Option<Box<Errors<N>>>,
    /// The length of that step, s.
    length: f64,
}

/// The factors of both systems.
#[derive(Clone)]
struct Factors<const N: usize, const R: usize> {
    /// The length of the steps that they are for, s; zero: there are none.
    length: f64,
    /// A where they were made.
    a: RowMatrix<N, R>,
    real: Saddle<N, R>,
    complex: ComplexSaddle<N, R>,
}

impl<const N: usize, const R: usize> Factors<N, R> {
    fn none() -> Self {
        Factors {
            length: 0.0,
            a: RowMatrix::zeros(),
            real: Saddle::new(),
            complex: ComplexSaddle::new(),
        }
    }

    fn are_for(&self, h: f64) -> bool {
        (self.length - h).abs() <= EQUAL * h.abs()
    }
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
    /// Of forces without potential, and of the rows of time, −λ · b; after the last correction, W.
    powers: [f64; 2],
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
                powers: [0.0; 2],
            };
            Ok(Box::new(Radau {
                motion: Motion::new(),
                factors: Box::new([Factors::none(), Factors::none()]),
                equations: Index1::detecting_densely(bench, scale.final_lengths())?,
                placed: false,
                scale,
                stages: Box::new([stage; 3]),
                memory: Memory::new(),
                loosest: (settings.tolerance).map_or(LOOSEST, |part| LOOSEST.min(TIGHT * part)),
                errors: settings.tolerance.map(|_| Box::new(Errors::none())),
                length: 0.0,
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
        if !self.factors[0].are_for(h) {
            self.factors.swap(0, 1);
        }
        if !self.factors[0].are_for(h) {
            self.factors[0].length = 0.0;
        }
        let known = self.memory.before(&bench.state, bench.system.inputs());
        let mut corrections = self.attempt(bench, h, known.as_ref());
        if known.is_some() && corrections.is_err() {
            self.factors[0].length = 0.0;
            corrections = self.attempt(bench, h, None);
        }
        if corrections.is_err() {
            self.factors[0].length = 0.0;
        }
        let corrections = corrections?;
        bench.counters.iterations += corrections;
        bench.counters.stages += NODES.len() as u64;
        self.end(bench, h)?;
        if corrections > FEW {
            self.factors[0].length = 0.0;
        }
        Ok(())
    }

    /// The stages of a step of h; returns the number of corrections. `known`: the last step, and whether it had the same inputs. If it
    /// had not, it does not tell how exact the first correction is.
    fn attempt<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
        known: Option<&(Known<N, R>, bool)>,
    ) -> Result<u64, Fault> {
        let v0 = bench.state.velocities;
        let start = start(bench, self.errors.is_some());
        for (i, stage) in self.stages.iter_mut().enumerate() {
            (stage.v, stage.lambda) = match known {
                Some((last, _)) => {
                    let place = 1.0 + NODES[i] * h / last.length;
                    (last.velocities_at(place), last.multipliers_at(place))
                }
                None => (v0, zeros()),
            };
            stage.turn = vector(|k| h * NODES[i] * v0[k]);
        }
        let mut progress = Progress::new();
        let (mut last, mut enough) = (f64::INFINITY, 0.0);
        loop {
            self.evaluate(bench, h);
            let fresh = self.factors[0].length == 0.0;
            if fresh && !self.factor(bench, h) {
                return Err(progress.lost());
            }
            let change = self.correct(&start[0], h);
            let size = bench.yardstick.measure(&change);
            if last.is_infinite() && known.is_none() && R > 0 && !(h.abs() * size < NEARBY) {
                return Err(progress.lost());
            }
            let end = &self.stages[2];
            let (sizes, floor) = Progress::sizes(bench, &change, (&end.q, &end.v), h);
            if last.is_infinite() && known.is_some_and(|&(_, has_inputs)| has_inputs) {
                let [size, speed] = sizes;
                enough = (LOOSE * (size / speed).powf(1.5)).min(self.loosest);
            }
            if progress.will_settle(sizes, (floor, enough), h, bench.max_iterations)? {
                self.arrive(bench, h, &start);
                return Ok(progress.count());
            }
            if size > SLOW * last {
                if fresh && !(size < last) {
                    return Err(progress.lost());
                }
                self.factors[0].length = 0.0;
            }
            last = size;
        }
    }

    /// Factors both systems at the second stage, as the one in the middle, which was evaluated last; false if one is singular or
    /// not finite.
    fn factor<S: System<Q, N, R>>(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> bool {
        let t = bench.state.time + NODES[1] * h;
        let Stage { q, v, .. } = self.stages[1];
        let motion = &mut self.motion;
        motion.tangents(&bench.system, t, &q, &v);
        motion.combine(h * REAL, h * REAL * h * REAL);
        let factors = &mut self.factors[0];
        factors.a.overwrite(&bench.geometry.a);
        factors.length = 0.0;
        if !(factors.real).factor(&motion.jacobian, &factors.a, &factors.a) {
            return false;
        }
        let of = h * COMPLEX;
        let (mass, p_q, f_v, f_q) = (&motion.mass, &motion.p_q, &motion.f_v, &motion.f_q);
        let entry = |i: usize, j: usize| {
            Complex::from(mass[i][j]) + of * (p_q[i][j] - f_v[i][j]) - of * of * f_q[i][j]
        };
        if !(factors.complex).factor(entry, &factors.a, &factors.real) {
            return false;
        }
        factors.length = h;
        true
    }

    /// θ at the stages.
    fn turn<S: System<Q, N, R>>(&mut self, h: f64) {
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
    }

    /// After the last correction: the positions that belong to it and, with a tolerance, the estimate of the error.
    fn arrive<S: System<Q, N, R>>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
        h: f64,
        [p0, f0]: &[SVector<f64, N>; 2],
    ) {
        self.turn::<S>(h);
        let Bench { system, state, .. } = bench;
        for (stage, node) in self.stages.iter_mut().zip(NODES) {
            stage.q = system.advance(&state.positions, &stage.turn, 1.0);
            let t = state.time + node * h;
            stage.powers[0] = system.nonconservative_power(t, &stage.q, &stage.v);
            if S::STRUCTURE.rheonomic && R > 0 {
                let (mut phi, mut b) = (zeros(), zeros());
                system.constraints(t, &stage.q, &mut phi, &mut Discard, &mut b);
                stage.powers[1] = -dot(&stage.lambda, &b);
            }
        }
        let Some(errors) = &mut self.errors else {
            return;
        };
        for stage in &mut *self.stages {
            system.momentum(&stage.q, &stage.v, &mut stage.p);
        }
        let stages = &*self.stages;
        let moved = weighted(1.0, &EMBEDDED, &stages.each_ref().map(|stage| stage.turn));
        let gained = weighted(1.0, &EMBEDDED, &stages.each_ref().map(|stage| stage.p - p0));
        let (of, v0) = (h * REAL, &state.velocities);
        let moved: SVector<f64, N> = vector(|k| of * v0[k] + moved[k]);
        let Motion { f_q, p_q, .. } = &self.motion;
        let mut change: SVector<f64, N> =
            vector(|k| of * (f0[k] + dot(&f_q[k], &moved)) - dot(&p_q[k], &moved) + gained[k]);
        let factors = &self.factors[0];
        factors.real.solve(&mut change, &mut zeros(), &factors.a);
        **errors = Errors {
            turn: vector(|k| moved[k] + of * change[k]),
            change,
            way: stages[2].turn,
            gained: stages[2].v - state.velocities,
            works: [0.0; 2],
        };
        if S::STRUCTURE.rheonomic {
            let powers = stages
                .each_ref()
                .map(|stage| SVector::from([stage.powers[0]]));
            let works = WEIGHTS
                .each_ref()
                .map(|weights| weighted(h, weights, &powers));
            let first = system.nonconservative_power(state.time, &state.positions, v0);
            let off = of * first + weighted(1.0, &EMBEDDED, &works)[0];
            errors.works = [off.abs(), works[2][0].abs()];
        }
        self.length = h;
    }

    /// The equations at the stages.
    fn evaluate<S: System<Q, N, R>>(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) {
        let (t0, q0) = (bench.state.time, bench.state.positions);
        self.turn::<S>(h);
        let stages = &mut *self.stages;
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
            stage.rates = vector(|i| geometry.velocity_row(i, &stage.v));
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
        let factors = &mut self.factors[0];
        factors.real.solve(&mut x, &mut mu, &factors.a);
        let [re, im] = [1, 2].map(|k| weighted::<N>(1.0, &INTO_BASIS[k], &missing));
        let mut z: [Complex<f64>; N] = std::array::from_fn(|i| Complex::new(re[i], im[i]));
        let [re, im] = [1, 2].map(|k| weighted::<R>(1.0, &INTO_BASIS[k], &open));
        let mut nu: [Complex<f64>; R] = std::array::from_fn(|i| Complex::new(re[i], im[i]));
        factors.complex.solve(&mut z, &mut nu, &factors.real);
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
        for (stage, weight) in self.stages.iter().zip(WEIGHTS[2]) {
            bench.add_works(h * weight, stage.powers);
        }
        let Stage {
            mut q,
            mut v,
            lambda,
            ..
        } = self.stages[2];
        let [first, second, third] = self.stages.each_ref().map(|stage| stage.v);
        let known = Known {
            length: h,
            velocities: [bench.state.velocities, first, second, third],
            multipliers: self.stages.each_ref().map(|stage| stage.lambda),
        };
        bench.multipliers = Some(lambda);
        let t1 = t0 + h;
        if R > 0 {
            self.equations.begin();
            self.equations.close(bench, t1, &mut q, &self.scale)?;
            self.equations.project(bench, &mut v);
        }
        bench.commit(t1, q, v, R > 0)?;
        self.memory.keep(&bench.state, bench.system.inputs(), known);
        self.placed = R > 0;
        Ok(())
    }
}

/// p at the beginning of a step, and F if it is wanted.
fn start<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    bench: &Bench<S, Q, N, R>,
    with_forces: bool,
) -> [SVector<f64, N>; 2] {
    let state = &bench.state;
    let (mut p, mut f) = (zeros(), zeros());
    let (q, v) = (&state.positions, &state.velocities);
    match with_forces {
        true => (bench.system).balance(state.time, q, v, &mut p, &mut f),
        false => bench.system.momentum(q, v, &mut p),
    }
    [p, f]
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

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Radau<Q, N, R>
{
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        self.step(bench, h)
    }

    fn refresh(&mut self) {
        self.placed = false;
    }

    fn estimate(&self, bench: &Bench<S, Q, N, R>) -> Option<Estimate> {
        let errors = self.errors.as_ref()?;
        let end = &self.stages[2].v;
        Some(errors.estimate(
            self.length.abs(),
            (&bench.yardstick, bench.system.states()),
            end,
        ))
    }

    fn rank_margin(&mut self, bench: &mut Bench<S, Q, N, R>) -> Option<RankMargin> {
        self.equations.margin_here(bench, &mut self.placed)
    }

    fn weakest_rows(&mut self, bench: &Bench<S, Q, N, R>) -> SVector<f64, R> {
        self.equations.weakest_rows(bench)
    }
}
