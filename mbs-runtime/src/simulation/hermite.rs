//! The motion between the ends of a step, from positions and velocities there.
//!
//! A cubic in the tangent space of the beginning, q(s) = q₀ ⊕ x(s): x(0) = 0, x(1) = q₁ ⊖ q₀, and the rates of x at the
//! ends belong to v₀ and v₁. Its error is of fourth order in the step. No equation is evaluated, so that an event can be
//! looked for on it; [`Simulation::look_at`](super::Simulation::look_at) gives states that satisfy the constraints.

use crate::flow::{transport, unroll};
use crate::linear::{scaled, vector};
use crate::{State, System};
use nalgebra::SVector;

/// The cubic of a step.
pub(super) struct Hermite<const Q: usize, const N: usize> {
    /// When it begins and how long it is, s.
    time: f64,
    length: f64,
    begin: SVector<f64, Q>,
    /// x(1), x'(0) and x'(1).
    moved: SVector<f64, N>,
    rates: [SVector<f64, N>; 2],
}

impl<const Q: usize, const N: usize> Hermite<Q, N> {
    /// Between two states, the second of which is the later one.
    pub(super) fn new<S: System<Q, N, R>, const R: usize>(
        system: &S,
        begin: &State<Q, N, R>,
        end: &State<Q, N, R>,
    ) -> Self {
        let length = end.time - begin.time;
        let moved = system.difference(&begin.positions, &end.positions);
        let mut last = scaled(length, &end.velocities);
        unroll::<S, Q, N, R>(&moved, &mut last);
        Hermite {
            time: begin.time,
            length,
            begin: begin.positions,
            moved,
            rates: [scaled(length, &begin.velocities), last],
        }
    }

    /// Time, q and v after the part s of the step.
    pub(super) fn at<S: System<Q, N, R>, const R: usize>(
        &self,
        system: &S,
        s: f64,
    ) -> (f64, SVector<f64, Q>, SVector<f64, N>) {
        let end = s * s * (3.0 - 2.0 * s);
        let slopes = [s * (1.0 - s).powi(2), -s * s * (1.0 - s)];
        let end_rate = 6.0 * s * (1.0 - s);
        let slope_rates = [(1.0 - s) * (1.0 - 3.0 * s), s * (3.0 * s - 2.0)];
        let combine = |moved: f64, slopes: [f64; 2], i: usize| {
            moved * self.moved[i] + slopes[0] * self.rates[0][i] + slopes[1] * self.rates[1][i]
        };
        let x: SVector<f64, N> = vector(|i| combine(end, slopes, i));
        let rate = |i| combine(end_rate, slope_rates, i) / self.length;
        let mut v = [vector(rate)];
        transport::<S, Q, N, R>(&x, &mut v);
        let q = system.advance(&self.begin, &x, 1.0);
        (self.time + s * self.length, q, v[0])
    }
}
