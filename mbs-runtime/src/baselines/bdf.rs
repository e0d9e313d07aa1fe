//! Backward differentiation of the equations with position rows (index 3), of variable order and step: what commercial
//! codes of multibody dynamics offer.
//!
//! ```text
//! Σ_j α_j p_j = F₀ + A₀ᵀλ,   Σ_j α_j θ_j = v₀ (T(θ₀)⁻¹ v₀ for rotations),   φ(q₀) = 0        j = 0: the new instant
//! ```
//!
//! with the differentiated Lagrange polynomial through the last instants, wherever they are (variable coefficients:
//! Brayton, Gustavson, Hachtel, Proc. IEEE 60, 1972, 98–108). As in the stiff integrators of index 3 of such codes (Orlandea,
//! Chace, Calahan, J. Eng. Ind. 99, 1977, 773–779; Negrut & Ortiz, ASME DETC 2005), the rows are scaled with the step in
//! Newton's equations, and the error of positions alone is controlled: that of velocities and multipliers is of lower order.
//!
//! The order is that of the longest step, as in the codes of the literature (Brenan, Campbell, Petzold: Numerical
//! Solution of Initial-Value Problems in Differential-Algebraic Equations, 1996, 5.2), which raise the order only if
//! the differences decrease with the order. For undamped mechanisms this is not enough: with tolerances of 1e-2 orders
//! from 3 on amplify oscillations. Here the differences have to decrease faster from order to order; otherwise the
//! order is at most 2.

use super::bdf_history::{History, MOST_ORDER};
use super::bench::Bench;
use super::index1::Index1;
use super::motion::{Motion, consistent};
use super::rule::{AnyRule, Rule};
use super::saddle::Saddle;
use crate::BdfSettings;
use crate::fault::Fault;
use crate::flow::unroll;
use crate::linear::{add, finite, scaled, vector};
use crate::yardstick::Yardstick;
use crate::{Method, Settings, System};
use nalgebra::SVector;

/// Newton's corrections of positions end below this fraction of the tolerance of a step.
const NEWTON: f64 = 1e-2;
const NEWTON_ITERATIONS: usize = 8;
/// A step below this fraction of the given one is an error.
const SMALLEST: f64 = 1e-9;
/// An instant that follows the newest one of the history by less than this part of a step is not kept: a polynomial through both would
/// multiply the residuals of the rates of rows, which a step of index 3 leaves, by the length of a step over their distance.
const SHORT: f64 = 0.1;
/// Growth below which a step is left as it is, and most growth.
const GROWTH: [f64; 2] = [1.2, 2.0];
/// Pivots of rows that follow from others, below this fraction of the largest, in poses that violate the rows:
/// predicted ones do, and a redundant row that is not left out makes the step useless.
const DEPENDENT: f64 = 1e-8;
/// (ω h)² up to which an order is taken. Orders 3 to 5 are not A-stable: an undamped oscillation grows at the rate
/// ω (ω h)³/4 with order 3, ω (ω h)⁵/3 with order 4.
const RESOLVED: [f64; MOST_ORDER + 1] = [
    f64::INFINITY,
    f64::INFINITY,
    f64::INFINITY,
    0.04,
    0.04,
    0.04,
];

#[derive(Clone)]
pub(crate) struct Bdf<const Q: usize, const N: usize, const R: usize> {
    settings: BdfSettings,
    history: Box<History<Q, N>>,
    order: usize,
    /// Accepted steps since order or step were changed.
    since: usize,
    /// The step in use, s; zero before the first.
    size: f64,
    /// How far the state is ahead of the newest instant of the history, s; zero unless the last steps were shorter than the part [`SHORT`] of a step.
    ahead: f64,
    lambda: SVector<f64, R>,
    motion: Motion<N>,
    saddle: Saddle<N, R>,
    /// The equations at acceleration level, for the first step and those after a jump.
    equations: Box<Index1<N, R>>,
}

/// The end of a step that may be accepted.
struct Trial<const Q: usize, const N: usize, const R: usize> {
    q: SVector<f64, Q>,
    v: SVector<f64, N>,
    /// θ₀.
    turn: SVector<f64, N>,
    lambda: SVector<f64, R>,
}

impl<const Q: usize, const N: usize, const R: usize> Bdf<Q, N, R> {
    /// For the method of the settings.
    pub(crate) fn rule<S: System<Q, N, R>>(
        _: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        let Method::Bdf(bdf) = &settings.method else {
            return None;
        };
        Some(Ok(Box::new(Bdf::new(bdf))))
    }

    fn new(settings: &BdfSettings) -> Self {
        Bdf {
            settings: *settings,
            history: Box::new(History::new()),
            order: 1,
            since: 0,
            size: 0.0,
            ahead: 0.0,
            lambda: SVector::zeros(),
            motion: Motion::new(),
            saddle: Saddle::with_threshold(DEPENDENT),
            equations: Box::new(Index1::new(0.0)),
        }
    }

    fn refresh(&mut self) {
        self.history.keep(0);
        self.lambda = SVector::zeros();
        (self.size, self.ahead) = (0.0, 0.0);
    }

    /// Advances by h, in steps of its own of which none is longer.
    fn advance<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        Fault::check_length(h, false)?;
        let end = bench.state.time + h;
        if self.history.len() == 0 {
            self.start(bench, h)?;
        }
        let (mut left, mut failures) = (h, 0);
        while left > SMALLEST * h.min(self.size) {
            // The remaining time is divided into equal steps, so that few are very short; these are no part of the history.
            let parts = (left / self.size.min(h) - 1e-3).ceil().max(1.0);
            let trial = left / parts;
            let reach = self.ahead + trial;
            let outcome = self.try_step(bench, trial);
            if let Ok((error, next)) = &outcome
                && *error <= 1.0
            {
                failures = 0;
                left -= trial;
                if reach < SHORT * self.size {
                    self.pass(bench, trial, next)?;
                } else {
                    self.choose(&bench.yardstick, reach, *error, next, h / reach);
                    self.accept(bench, trial, next)?;
                }
                continue;
            }
            bench.counters.rejected += 1;
            failures += 1;
            let root = 1.0 / (self.order + 1) as f64;
            let factor = match outcome {
                Ok((error, _)) if error.is_finite() => 0.9 * error.powf(-root),
                _ => 0.25,
            };
            self.size = reach * factor.clamp(0.25, 0.9);
            self.since = 0;
            if failures >= 3 {
                // The extrapolation from the history failed.
                self.order = 1;
                self.history.keep(1);
                if self.ahead > 0.0 {
                    // No step from the newest instant to beyond the state is short enough.
                    let size = self.size;
                    self.refresh();
                    self.start(bench, size)?;
                }
            }
            if self.size < SMALLEST * h {
                return Err(Fault::Underflow {
                    row: None,
                    step: trial,
                });
            }
        }
        bench.state.time = end;
        Ok(())
    }

    /// The first instant, and the length of a first step whose error will be a part of the tolerance.
    fn start<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(), Fault> {
        let (acceleration, lambda) = consistent(&mut self.equations, bench)?;
        let state = &bench.state;
        let (q, v) = (state.positions, state.velocities);
        bench.system.momentum(&q, &v, &mut self.motion.p);
        self.history.push(state.time, &q, &v, &self.motion.p);
        self.lambda = lambda;
        (self.order, self.since) = (1, 0);
        let yardstick = &bench.yardstick;
        let bound = 0.2 * self.bound(yardstick, &q) / yardstick.measure(&acceleration);
        self.size = bound.sqrt().min(h);
        Ok(())
    }

    /// The tolerance, in lengths of the mechanism and radians.
    fn bound(&self, yardstick: &Yardstick<Q, N>, q: &SVector<f64, Q>) -> f64 {
        self.settings.tolerance * yardstick.farthest(q)
    }

    /// A step of h with the order in use; returns its error in tolerances.
    fn try_step<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<(f64, Trial<Q, N, R>), Fault> {
        let holonomic = S::STRUCTURE.holonomic_rows;
        let (t1, q0) = (bench.state.time + h, *self.history.newest());
        self.history.seek(&bench.system, t1);
        let (alpha, past, past_p) = self.history.past(self.order);
        let [mut turn, mut v] = self.history.predict(self.order);
        let mut lambda = SVector::zeros();
        let bound = self.bound(&bench.yardstick, &q0);
        let (mut last, mut ended) = (f64::INFINITY, false);
        for _ in 0..NEWTON_ITERATIONS {
            // θ₀ of v₀; for rotations an iteration that shrinks errors by the angle of a step.
            for _ in 0..if S::ROTATIONS.is_empty() { 1 } else { 3 } {
                let mut rate = v;
                unroll::<S, Q, N, R>(&turn, &mut rate);
                turn = vector(|i| (rate[i] - past[i]) / alpha);
            }
            let q = bench.system.advance(&q0, &turn, 1.0);
            if ended {
                if !finite(&q) || !finite(&v) {
                    break;
                }
                bench.counters.stages += 1;
                let error = self.history.error(&bench.yardstick, self.order, &turn);
                let error = error.unwrap_or(f64::INFINITY) / bound;
                return Ok((error, Trial { q, v, turn, lambda }));
            }
            let Bench {
                system,
                geometry,
                phi,
                ..
            } = &mut *bench;
            system.constraints(t1, &q, phi, geometry.a.entries_mut(), &mut geometry.b);
            let motion = &mut self.motion;
            motion.balance(system, t1, &q, &v);
            motion.tangents(system, t1, &q, &v);
            // All divided by α₀. All of λ is found anew: the large multiplier of a row with a small pivot, beside a
            // singular pose, must not stay in the next steps.
            let mut change: SVector<f64, N> =
                vector(|i| (motion.f[i] - past_p[i]) / alpha - motion.p[i]);
            motion.combine(1.0 / alpha, 1.0 / (alpha * alpha));
            let mut rows = vector(|i| {
                if i < holonomic {
                    -alpha * phi[i]
                } else {
                    -geometry.velocity_row(i, &v)
                }
            });
            if !self
                .saddle
                .factor(&motion.jacobian, &geometry.a, &geometry.a)
            {
                return Err(Fault::Mass);
            }
            self.saddle.solve(&mut change, &mut rows, &geometry.a);
            bench.counters.regularised += u64::from(self.saddle.left_out() > 0);
            bench.counters.iterations += 1;
            add(&mut v, &change);
            lambda = scaled(alpha, &rows);
            let size = bench.yardstick.measure(&change) / alpha;
            ended = size <= NEWTON * bound;
            if !ended && !(size < 2.0 * last) {
                break;
            }
            last = size;
        }
        Err(Fault::Flow {
            residual: last,
            iterations: NEWTON_ITERATIONS,
        })
    }

    /// Order and length of the next step, after one of h with this error in tolerances of `bound`.
    ///
    /// The order in use, that above it or that below it is taken, whichever allows the longest step; all of them only
    /// with steps that resolve the oscillations in the history ([`RESOLVED`]). Where steps are bounded, to `most` times
    /// h, the higher of equals.
    fn choose(
        &mut self,
        yardstick: &Yardstick<Q, N>,
        h: f64,
        error: f64,
        next: &Trial<Q, N, R>,
        most: f64,
    ) {
        let bound = self.bound(yardstick, &next.q);
        self.since += 1;
        let k = self.order;
        // How many times as long a step may be; `None` where that is not known.
        let growth = |order: usize, safety: f64| {
            let error = match order == k {
                true => error,
                false => self.history.error(yardstick, order, &next.turn)? / bound,
            };
            let accurate = error.max(1e-12).powf(-1.0 / (order + 1) as f64) / safety;
            let coarseness = self
                .history
                .coarseness(yardstick, order, (&next.turn, &next.v));
            let stable = (RESOLVED[order] / coarseness.max(f64::MIN_POSITIVE)).sqrt();
            Some((accurate.min(stable).min(most), stable))
        };
        if k > 2
            && let Some((_, stable)) = growth(k, 1.0)
            && stable < 1.0
        {
            // At once, because the next steps would amplify the gain of such a step.
            let factor = growth(k - 1, 1.3).map_or(1.0, |(factor, _)| factor);
            (self.order, self.size) = (k - 1, h * factor.clamp(0.25, 1.0));
            self.since = 0;
            return;
        }
        // Errors of a new order or step show after as many steps as it takes in.
        if self.since <= k {
            return;
        }
        let mut best = (k, growth(k, 1.2).map_or(1.0, |(factor, _)| factor));
        if k > 1
            && let Some((factor, _)) = growth(k - 1, 1.3)
            && factor > best.1
        {
            best = (k - 1, factor);
        }
        if k < usize::from(self.settings.max_order)
            && let Some((factor, stable)) = growth(k + 1, 1.4)
            && factor >= best.1
            && stable >= 1.0
        {
            best = (k + 1, factor);
        }
        let (order, factor) = best;
        if !(0.9..GROWTH[0]).contains(&factor) || order != k {
            self.size = h * factor.clamp(0.5, GROWTH[1]);
            self.order = order;
            self.since = 0;
        }
    }

    /// The state moves to the new instant, which becomes no part of the past. The multipliers of so short a step are not those of the
    /// motion: they make up for the rates that the step before has left.
    fn pass<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
        next: &Trial<Q, N, R>,
    ) -> Result<(), Fault> {
        self.ahead += h;
        let lambda = self.lambda;
        self.go_to(bench, h, next, lambda)
    }

    /// The state moves to the new instant, with these multipliers there.
    fn go_to<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
        next: &Trial<Q, N, R>,
        lambda: SVector<f64, R>,
    ) -> Result<(), Fault> {
        let (t0, q0, v0) = (
            bench.state.time,
            bench.state.positions,
            bench.state.velocities,
        );
        bench.multipliers = Some(lambda);
        let ends = [&self.lambda, &lambda];
        bench.trapezoid_works(t0, h, (&q0, &v0), (&next.q, &next.v), ends);
        bench.commit(t0 + h, next.q, next.v, false)
    }

    /// The new instant becomes part of the past.
    fn accept<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
        next: &Trial<Q, N, R>,
    ) -> Result<(), Fault> {
        self.go_to(bench, h, next, next.lambda)?;
        bench.system.momentum(&next.q, &next.v, &mut self.motion.p);
        let time = bench.state.time;
        self.history.push(time, &next.q, &next.v, &self.motion.p);
        (self.lambda, self.ahead) = (next.lambda, 0.0);
        Ok(())
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Bdf<Q, N, R>
{
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        Bdf::advance(self, bench, h)
    }

    fn refresh(&mut self) {
        Bdf::refresh(self);
    }
}
