//! The equations of motion and their tangents, for implicit methods.

use super::bench::Bench;
use super::index1::Index1;
use crate::System;
use crate::fault::Fault;
use crate::flow::transport;
use crate::linear::{RowMatrix, dot, vector};
use nalgebra::SVector;

/// Corrections of the velocities below this fraction of them end an iteration …
const CONVERGED: f64 = 1e-12;
/// … or below this one, when they no longer shrink.
const STILL: f64 = 1e-7;

/// Corrections that shrink at a constant rate end at both of these times the way of the step, in sizes or radians, which counts
/// as this at least and as 1 at most: what many short steps leave adds up.
const FINEST: f64 = 0.01;
/// The first one has no rate; what it leaves has been found as large as it is.
const UNKNOWN: f64 = 100.0;
/// … or where they no longer shrink, below so many times that.
const STIRRED: f64 = 1e4;

/// p, F and the tangents at one instant.
#[derive(Clone)]
pub(crate) struct Motion<const N: usize> {
    pub(crate) p: SVector<f64, N>,
    pub(crate) f: SVector<f64, N>,
    pub(crate) mass: RowMatrix<N, N>,
    pub(crate) f_q: RowMatrix<N, N>,
    pub(crate) f_v: RowMatrix<N, N>,
    pub(crate) p_q: RowMatrix<N, N>,
    /// J of the method.
    pub(crate) jacobian: RowMatrix<N, N>,
}

impl<const N: usize> Motion<N> {
    pub(crate) fn new() -> Self {
        Motion {
            p: SVector::zeros(),
            f: SVector::zeros(),
            mass: RowMatrix::zeros(),
            f_q: RowMatrix::zeros(),
            f_v: RowMatrix::zeros(),
            p_q: RowMatrix::zeros(),
            jacobian: RowMatrix::zeros(),
        }
    }

    /// p and F.
    pub(crate) fn balance<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) {
        system.balance(t, q, v, &mut self.p, &mut self.f);
    }

    /// M and the tangents.
    pub(crate) fn tangents<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) {
        system.balance_tangents(
            t,
            q,
            v,
            self.mass.entries_mut(),
            self.f_q.entries_mut(),
            self.f_v.entries_mut(),
            self.p_q.entries_mut(),
        );
    }

    /// F − (∂p/∂q) v − M v̇, the residual of the equations without rows, after `balance` and `tangents` at the same
    /// state.
    pub(crate) fn defect(
        &self,
        v: &SVector<f64, N>,
        acceleration: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        vector(|i| self.f[i] - dot(&self.p_q[i], v) - dot(&self.mass[i], acceleration))
    }

    /// J = M + c (∂p/∂q − ∂F/∂v) − k ∂F/∂q, with c = ∂v/∂v̇ and k = ∂q/∂v̇ of the method.
    ///
    /// Some terms of the derivatives of (∂p/∂q) v and M v̇ are left out, so that the iteration is a little slower if M
    /// varies.
    pub(crate) fn combine(&mut self, c: f64, k: f64) {
        let (mass, p_q) = (&self.mass.data.0, &self.p_q.data.0);
        let (f_q, f_v) = (&self.f_q.data.0, &self.f_v.data.0);
        for (i, row) in self.jacobian.entries_mut().iter_mut().enumerate() {
            for j in 0..N {
                row[j] = mass[i][j] + c * (p_q[i][j] - f_v[i][j]) - k * f_q[i][j];
            }
        }
    }
}

/// ã = a T(θ) of the holonomic rows: how they answer to a change of θ, where `turn` is θ.
pub(crate) fn move_rows<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    a: &RowMatrix<N, R>,
    turn: &SVector<f64, N>,
    moved: &mut RowMatrix<N, R>,
) {
    **moved = **a;
    if !S::ROTATIONS.is_empty() {
        let holonomic = S::STRUCTURE.holonomic_rows;
        crate::flow::pull_back_rows::<S, Q, N, R>(turn, &mut moved.rows_mut()[..holonomic]);
    }
}

/// x ← T(θ) x: a change of θ as a change of the configuration.
pub(crate) fn carry<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    turn: &SVector<f64, N>,
    x: &mut SVector<f64, N>,
) {
    let mut carried = [*x];
    transport::<S, Q, N, R>(turn, &mut carried);
    *x = carried[0];
}

/// v̇ and λ that satisfy the rows at acceleration level at the state of the bench.
pub(crate) fn consistent<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    equations: &mut Index1<N, R>,
    bench: &mut Bench<S, Q, N, R>,
) -> Result<(SVector<f64, N>, SVector<f64, R>), Fault> {
    let (t, q, v) = (
        bench.state.time,
        bench.state.positions,
        bench.state.velocities,
    );
    equations.place(bench, t, &q)?;
    let acceleration = equations.acceleration(bench, t, &q, &v);
    Ok((acceleration, equations.lambda))
}

/// The end of a Newton iteration whose corrections of the velocities are given.
pub(crate) struct Progress {
    last: f64,
    count: usize,
}

impl Progress {
    pub(crate) fn new() -> Self {
        Progress {
            last: f64::INFINITY,
            count: 0,
        }
    }

    /// The size of a correction of the velocities v at q, their speed, and the floor.
    pub(crate) fn sizes<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        bench: &Bench<S, Q, N, R>,
        change: &SVector<f64, N>,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
        h: f64,
    ) -> ([f64; 2], f64) {
        let yardstick = &bench.yardstick;
        let floor = yardstick.imperceptible(q, h);
        let speed = yardstick.measure(v);
        let whole = || speed.max(floor / CONVERGED);
        let states = bench.system.states();
        let sizes = [yardstick.correction(states, (change, v), whole), speed];
        (sizes, floor)
    }

    /// Whether corrections of this size end the iteration, with velocities of `speed`; below `floor` they are round-off.
    /// All in lengths of the mechanism and radians a second.
    pub(crate) fn settles(
        &mut self,
        [size, speed]: [f64; 2],
        floor: f64,
        most: usize,
    ) -> Result<bool, Fault> {
        let settled = size <= (CONVERGED * speed).max(floor)
            || (size >= 0.5 * self.last && size <= (STILL * speed).max(8.0 * floor));
        self.go_on(size, settled, most)
    }

    fn go_on(&mut self, size: f64, settled: bool, most: usize) -> Result<bool, Fault> {
        self.count += 1;
        self.last = size;
        if settled {
            return Ok(true);
        }
        if self.count >= most || !size.is_finite() {
            return Err(Fault::Flow {
                residual: size,
                iterations: self.count,
            });
        }
        Ok(false)
    }

    /// The same where corrections shrink at a constant rate: whether the next one, at the rate of this one, is at most `enough`
    /// of the speed, or round-off in a step of h.
    pub(crate) fn will_settle(
        &mut self,
        [size, speed]: [f64; 2],
        (floor, enough): (f64, f64),
        h: f64,
        most: usize,
    ) -> Result<bool, Fault> {
        let rate = match self.last.is_finite() {
            true => (size / self.last).min(1.0),
            false => UNKNOWN,
        };
        let part = (h.abs() * speed).clamp(FINEST, 1.0);
        let round_off = part * (CONVERGED * speed).max(floor);
        let is_still = (0.5..=1.0).contains(&rate) && size <= STIRRED * round_off;
        self.go_on(
            size,
            size * rate <= round_off.max(enough * speed) || is_still,
            most,
        )
    }

    /// The matrix of the iteration is singular or not finite.
    pub(crate) fn lost(&self) -> Fault {
        Fault::Flow {
            residual: self.last,
            iterations: self.count,
        }
    }

    pub(crate) fn count(&self) -> u64 {
        self.count as u64
    }
}
