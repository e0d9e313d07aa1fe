//! Parallelogram loops in a row in bar angles: crank 0, coupler 1, crank 1, … Each coupler is a pendulum on the tip of the
//! crank before it, and two rows put its end on the tip of the next one.
//!
//! The order of elimination is that of the chain: a crank, its coupler, the two rows of the loop, the next crank. The only
//! entries that come from elsewhere are the pivot and the right-hand side of the next crank, so that the elimination is one
//! loop over the bars.

use super::equations::{Equations, GRAVITY};

/// M of a bar about its end.
const BAR: f64 = 1.0 / 3.0;

/// Columns of L and inverse pivots of a loop.
#[derive(Clone, Copy, Default)]
struct Loop {
    /// sin(θ − ψ)/2.
    coriolis: f64,
    /// Below the pivot of the crank: the coupler, the two rows.
    coupler: f64,
    by_crank: [f64; 2],
    inverse_crank: f64,
    /// Below that of the coupler: the two rows.
    by_coupler: [f64; 2],
    inverse_coupler: f64,
    /// Below that of the first row: the second, the next crank.
    second: f64,
    next_by_first: f64,
    inverse_first: f64,
    /// Below that of the second row: the next crank.
    next_by_second: f64,
    inverse_second: f64,
}

/// The last factor of L loops with N = 2 L + 1 bars.
pub struct Chain<const L: usize, const N: usize> {
    sine: [f64; N],
    cosine: [f64; N],
    loops: [Loop; L],
    inverse_last: f64,
}

impl<const L: usize, const N: usize> Default for Chain<L, N> {
    fn default() -> Self {
        Chain {
            sine: [0.0; N],
            cosine: [0.0; N],
            loops: [Loop::default(); L],
            inverse_last: 0.0,
        }
    }
}

impl Loop {
    /// The factor of a loop from the sines and cosines of its crank, its coupler and the next crank, and from what the
    /// loop before has added to the pivot of its crank; with what it adds to that of the next one.
    #[inline(always)]
    fn factored([s1, s2, s3]: [f64; 3], [c1, c2, c3]: [f64; 3], added: f64) -> (Self, f64) {
        let coupling = 0.5 * (c1 * c2 + s1 * s2);
        let crank = BAR + 1.0 + added;
        // Inverse pivots whose divisions are independent of one another: with the determinant of both pivots.
        let both = crank * BAR - coupling * coupling;
        let inverse_crank = 1.0 / crank;
        let inverse_coupler = crank / both;
        let coupler = coupling * inverse_crank;
        let by_crank = [-s1 * inverse_crank, c1 * inverse_crank];
        let across = [-s2 + s1 * coupler, c2 - c1 * coupler];
        let by_coupler = across.map(|entry| entry * inverse_coupler);
        // The rows' pivots with the opposite sign.
        let first = across[0] * by_coupler[0] - s1 * by_crank[0];
        let mixed = across[0] * by_coupler[1] - s1 * by_crank[1];
        let last = across[1] * by_coupler[1] + c1 * by_crank[1];
        let inverse_first = -1.0 / first;
        let inverse_second = -first / (first * last - mixed * mixed);
        let second = -mixed * inverse_first;
        let next_by_first = s3 * inverse_first;
        let across = -c3 - second * s3;
        let next_by_second = across * inverse_second;
        let factor = Loop {
            coriolis: 0.5 * (s1 * c2 - c1 * s2),
            coupler,
            by_crank,
            inverse_crank,
            by_coupler,
            inverse_coupler,
            second,
            next_by_first,
            inverse_first,
            next_by_second,
            inverse_second,
        };
        (factor, -s3 * next_by_first - across * next_by_second)
    }

    /// Right-hand sides of the coupler and the rows after elimination of the crank, and what goes to the next crank.
    #[inline(always)]
    fn forwards(&self, crank: f64, coupler: f64, rows: [f64; 2]) -> (f64, [f64; 2], f64) {
        let coupler = coupler - self.coupler * crank;
        let first = rows[0] - self.by_crank[0] * crank - self.by_coupler[0] * coupler;
        let second =
            rows[1] - self.by_crank[1] * crank - self.by_coupler[1] * coupler - self.second * first;
        let next = -self.next_by_first * first - self.next_by_second * second;
        (coupler, [first, second], next)
    }

    /// Crank and coupler from their right-hand sides, those of the rows, and the next crank.
    #[inline(always)]
    fn back(&self, crank: f64, coupler: f64, rows: [f64; 2], next: f64) -> [f64; 2] {
        let second = rows[1] * self.inverse_second - self.next_by_second * next;
        let first = rows[0] * self.inverse_first - self.second * second - self.next_by_first * next;
        let coupler = coupler * self.inverse_coupler
            - self.by_coupler[0] * first
            - self.by_coupler[1] * second;
        let crank = crank * self.inverse_crank
            - self.coupler * coupler
            - self.by_crank[0] * first
            - self.by_crank[1] * second;
        [crank, coupler]
    }
}

impl<const L: usize, const N: usize> Chain<L, N> {
    /// Sines and cosines of a crank, its coupler and the next crank.
    #[inline(always)]
    fn around(&self, i: usize) -> [[f64; 3]; 2] {
        [&self.sine, &self.cosine].map(|of| [of[2 * i], of[2 * i + 1], of[2 * i + 2]])
    }

    #[inline(always)]
    fn turn(&mut self, bar: usize, angle: f64) {
        (self.sine[bar], self.cosine[bar]) = angle.sin_cos();
    }

    /// The way back, where `bars` and `rows` are the right-hand sides after elimination.
    #[inline(always)]
    fn back(&self, bars: &mut [f64; N], rows: &[[f64; 2]; L]) {
        bars[N - 1] *= self.inverse_last;
        for (i, factor) in self.loops.iter().enumerate().rev() {
            let [crank, coupler, next] = [bars[2 * i], bars[2 * i + 1], bars[2 * i + 2]];
            [bars[2 * i], bars[2 * i + 1]] = factor.back(crank, coupler, rows[i], next);
        }
    }

    /// The solution for the right-hand sides of the rows alone.
    #[inline(always)]
    fn by_rows(&self, row: impl Fn(usize) -> [f64; 2]) -> [f64; N] {
        let (mut bars, mut rows) = ([0.0; N], [[0.0; 2]; L]);
        for (i, factor) in self.loops.iter().enumerate() {
            (bars[2 * i + 1], rows[i], bars[2 * i + 2]) = factor.forwards(bars[2 * i], 0.0, row(i));
        }
        self.back(&mut bars, &rows);
        bars
    }

    /// Right-hand sides of a crank, its coupler and its rows.
    #[inline(always)]
    fn right(&self, i: usize, coriolis: f64, v: &[f64; N]) -> (f64, f64, [f64; 2]) {
        let [sine, cosine] = self.around(i);
        let [crank, coupler, next] = [0, 1, 2].map(|bar| v[2 * i + bar] * v[2 * i + bar]);
        (
            -1.5 * GRAVITY * cosine[0] - coriolis * coupler,
            -0.5 * GRAVITY * cosine[1] + coriolis * crank,
            [cosine, sine].map(|[a, b, c]| a * crank + b * coupler - c * next),
        )
    }
}

impl<const L: usize, const N: usize> Equations<N> for Chain<L, N> {
    fn start() -> [[f64; N]; 2] {
        let of_cranks =
            |value: f64| std::array::from_fn(|bar| if bar % 2 == 0 { value } else { 0.0 });
        [of_cranks(std::f64::consts::FRAC_PI_2), of_cranks(-1.0)]
    }

    #[inline(always)]
    fn place(&mut self, q: &[f64; N]) {
        self.turn(0, q[0]);
        let mut added = 0.0;
        for i in 0..L {
            self.turn(2 * i + 1, q[2 * i + 1]);
            self.turn(2 * i + 2, q[2 * i + 2]);
            let [sine, cosine] = self.around(i);
            (self.loops[i], added) = Loop::factored(sine, cosine, added);
        }
        self.inverse_last = 1.0 / (BAR + added);
    }

    #[inline(always)]
    fn accelerations(&self, v: &[f64; N], into: &mut [f64; N]) {
        let mut rows = [[0.0; 2]; L];
        let mut carried = 0.0;
        for (i, factor) in self.loops.iter().enumerate() {
            let (crank, coupler, row) = self.right(i, factor.coriolis, v);
            into[2 * i] = crank + carried;
            (into[2 * i + 1], rows[i], carried) = factor.forwards(into[2 * i], coupler, row);
        }
        into[N - 1] = -0.5 * GRAVITY * self.cosine[N - 1] + carried;
        self.back(into, &rows);
    }

    /// Both at once: the elimination of a loop waits for that of the loop before, and its right-hand sides fill the wait.
    #[inline(always)]
    fn evaluate(&mut self, q: &[f64; N], v: &[f64; N], into: &mut [f64; N]) {
        let mut rows = [[0.0; 2]; L];
        let (mut added, mut carried) = (0.0, 0.0);
        self.turn(0, q[0]);
        for i in 0..L {
            self.turn(2 * i + 1, q[2 * i + 1]);
            self.turn(2 * i + 2, q[2 * i + 2]);
            let [sine, cosine] = self.around(i);
            let factor;
            (factor, added) = Loop::factored(sine, cosine, added);
            self.loops[i] = factor;
            let (crank, coupler, row) = self.right(i, factor.coriolis, v);
            into[2 * i] = crank + carried;
            (into[2 * i + 1], rows[i], carried) = factor.forwards(into[2 * i], coupler, row);
        }
        self.inverse_last = 1.0 / (BAR + added);
        into[N - 1] = -0.5 * GRAVITY * self.cosine[N - 1] + carried;
        self.back(into, &rows);
    }

    #[inline(always)]
    fn missing_positions(&self) -> [f64; N] {
        self.by_rows(|i| {
            let [sine, cosine] = self.around(i);
            let [x, y] = [cosine, sine].map(|[a, b, c]| c - a - b);
            [1.0 + x, y]
        })
    }

    #[inline(always)]
    fn missing_velocities(&self, v: &[f64; N]) -> [f64; N] {
        self.by_rows(|i| {
            let [sine, cosine] = self.around(i);
            let along = |[a, b, c]: [f64; 3]| a * v[2 * i] + b * v[2 * i + 1] - c * v[2 * i + 2];
            [along(sine), -along(cosine)]
        })
    }

    fn energy(q: &[f64; N], v: &[f64; N]) -> f64 {
        let bar = |i: usize| 0.5 * BAR * v[i] * v[i] + 0.5 * GRAVITY * q[i].sin();
        let carried = |i: usize| {
            let coupling = 0.5 * (q[i] - q[i + 1]).cos();
            (0.5 * v[i] + coupling * v[i + 1]) * v[i] + GRAVITY * q[i].sin()
        };
        (0..N).map(bar).sum::<f64>() + (0..N - 1).step_by(2).map(carried).sum::<f64>()
    }
}
