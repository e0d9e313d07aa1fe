//! The last instants of a multistep method, with variable distances.

use crate::System;
use crate::linear::{add_scaled, vector};
use crate::yardstick::Yardstick;
use nalgebra::SVector;

/// Highest order of the backward differentiation that is stable for every stiff equation of interest.
pub(super) const MOST_ORDER: usize = 5;
/// Instants kept: one more than the predictor of the highest order needs, to judge an order above.
const KEPT: usize = MOST_ORDER + 2;

/// Instants, the newest first.
#[derive(Clone)]
pub(super) struct History<const Q: usize, const N: usize> {
    len: usize,
    times: [f64; KEPT],
    q: [SVector<f64, Q>; KEPT],
    v: [SVector<f64, N>; KEPT],
    p: [SVector<f64, N>; KEPT],
    /// The new instant, s.
    sought: f64,
    /// θ of each instant in the chart about the newest.
    turns: [SVector<f64, N>; KEPT],
}

impl<const Q: usize, const N: usize> History<Q, N> {
    pub(super) fn new() -> Self {
        History {
            len: 0,
            times: [0.0; KEPT],
            q: [SVector::zeros(); KEPT],
            v: [SVector::zeros(); KEPT],
            p: [SVector::zeros(); KEPT],
            sought: 0.0,
            turns: [SVector::zeros(); KEPT],
        }
    }

    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// The positions of the newest instant, about which increments are.
    pub(super) fn newest(&self) -> &SVector<f64, Q> {
        &self.q[0]
    }

    /// Forgets all but the newest `count`.
    pub(super) fn keep(&mut self, count: usize) {
        self.len = self.len.min(count);
    }

    pub(super) fn push(
        &mut self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        p: &SVector<f64, N>,
    ) {
        self.times.rotate_right(1);
        self.q.rotate_right(1);
        self.v.rotate_right(1);
        self.p.rotate_right(1);
        (self.times[0], self.q[0], self.v[0], self.p[0]) = (t, *q, *v, *p);
        self.len = (self.len + 1).min(KEPT);
    }

    /// Prepares for an instant that is sought: all positions as increments from the newest.
    pub(super) fn seek<S: System<Q, N, R>, const R: usize>(&mut self, system: &S, t: f64) {
        self.sought = t;
        for j in 0..self.len {
            self.turns[j] = system.difference(&self.q[0], &self.q[j]);
        }
    }

    /// α₀, and α_j of the first `order` instants: ẋ₀ ≈ Σ α_j x_j with the polynomial through them.
    fn derivative(&self, order: usize) -> (f64, [f64; KEPT]) {
        let t = self.sought;
        let times = &self.times[..order];
        let mut weights = [0.0; KEPT];
        for j in 0..order {
            let mut product = 1.0 / (times[j] - t);
            for m in (0..order).filter(|&m| m != j) {
                product *= (t - times[m]) / (times[j] - times[m]);
            }
            weights[j] = product;
        }
        (times.iter().map(|s| 1.0 / (t - s)).sum(), weights)
    }

    /// α₀, Σ_{j>0} α_j θ_j and Σ_{j>0} α_j p_j.
    pub(super) fn past(&self, order: usize) -> (f64, SVector<f64, N>, SVector<f64, N>) {
        let (alpha, weights) = self.derivative(order);
        (
            alpha,
            combine(&weights[..order], &self.turns),
            combine(&weights[..order], &self.p),
        )
    }

    /// Weights of the polynomial of this degree through the newest instants, where it is sought.
    fn extrapolation(&self, degree: usize) -> [f64; KEPT] {
        let mut weights = [0.0; KEPT];
        for j in 0..=degree {
            let mut product = 1.0;
            for m in (0..=degree).filter(|&m| m != j) {
                product *= (self.sought - self.times[m]) / (self.times[j] - self.times[m]);
            }
            weights[j] = product;
        }
        weights
    }

    /// θ and v extrapolated with a polynomial of at most this degree.
    pub(super) fn predict(&self, degree: usize) -> [SVector<f64, N>; 2] {
        let degree = degree.min(self.len - 1);
        let weights = self.extrapolation(degree);
        let weights = &weights[..=degree];
        [combine(weights, &self.turns), combine(weights, &self.v)]
    }

    /// The largest error of θ₀ by this order; `None` where too little of the past is known.
    pub(super) fn error(
        &self,
        yardstick: &Yardstick<Q, N>,
        order: usize,
        turn: &SVector<f64, N>,
    ) -> Option<f64> {
        let h = self.sought - self.times[0];
        if self.len <= order {
            // After one instant: what the change of v adds.
            let first: SVector<f64, N> = vector(|i| turn[i] - h * self.v[0][i]);
            return (order == 1).then(|| 0.5 * yardstick.measure(&first));
        }
        let [predicted, _] = self.predict(order);
        let difference: SVector<f64, N> = vector(|i| turn[i] - predicted[i]);
        Some(h / (self.sought - self.times[order]) * yardstick.measure(&difference))
    }

    /// The largest deviations of θ₀ and v₀ from the polynomials of this degree: the backward differences after as many,
    /// for even steps.
    fn differences(
        &self,
        yardstick: &Yardstick<Q, N>,
        degree: usize,
        (turn, v): (&SVector<f64, N>, &SVector<f64, N>),
    ) -> [f64; 2] {
        let [turns, rates] = self.predict(degree);
        let largest_of = |a: &SVector<f64, N>, b: &SVector<f64, N>| {
            let difference: SVector<f64, N> = vector(|i| a[i] - b[i]);
            yardstick.measure(&difference)
        };
        [largest_of(turn, &turns), largest_of(v, &rates)]
    }

    /// (ω h)² of an oscillation ω, from differences that are two orders apart: these are in phase. Those of v, which
    /// are differences of θ one order higher, show the jumps beside singular poses. Zero for orders up to 2, and
    /// infinite if the history is too short.
    pub(super) fn coarseness(
        &self,
        yardstick: &Yardstick<Q, N>,
        order: usize,
        ends: (&SVector<f64, N>, &SVector<f64, N>),
    ) -> f64 {
        if order <= 2 {
            return 0.0;
        }
        if self.len <= order {
            return f64::INFINITY;
        }
        let differences: [[f64; 2]; KEPT] = std::array::from_fn(|degree| match degree <= order {
            true => self.differences(yardstick, degree, ends),
            false => [0.0; 2],
        });
        let ratio = |degree: usize, of: usize| {
            differences[degree][of] / differences[degree - 2][of].max(f64::MIN_POSITIVE)
        };
        let worst = |degree: usize| ratio(degree, 0).max(ratio(degree - 1, 1));
        (3..=order).map(worst).fold(0.0, f64::max)
    }
}

/// Σ c_j x_j.
fn combine<const N: usize>(weights: &[f64], values: &[SVector<f64, N>; KEPT]) -> SVector<f64, N> {
    let mut sum = SVector::zeros();
    for (c, value) in weights.iter().zip(values) {
        add_scaled(&mut sum, *c, value);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Polynomials of the order are differentiated and extrapolated exactly, at uneven instants.
    #[test]
    fn coefficients_are_exact_for_polynomials() {
        let times = [0.0, 0.13, 0.2, 0.35, 0.41, 0.6, 0.66];
        let sought = 0.8;
        for order in 1..=MOST_ORDER {
            let x = |t: f64| SVector::from([t.powi(order as i32)]);
            let mut history = History::<1, 1>::new();
            for t in times {
                history.push(t, &x(t), &x(t), &x(t));
            }
            history.sought = sought;
            let (alpha, _, past) = history.past(order);
            let exact = order as f64 * sought.powi(order as i32 - 1);
            assert!((alpha * x(sought)[0] + past[0] - exact).abs() < 1e-9);
            let [_, v] = history.predict(order);
            assert!((v - x(sought)).amax() < 1e-9);
        }
    }
}
