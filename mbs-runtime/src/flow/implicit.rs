//! Newton's method for the end of an implicit trapezoid: p(q₁, v_b) − h/2 F(q₁, v_b) = known, q₁ = q₀ ⊕ h/2 (v_a + v_b).
//! Beside rows, forces that depend on velocities are those at v₁, to which a kick leads from v_b.

use super::group::pull_back;
use super::on_rows::OnRows;
use crate::System;
use crate::fault::Fault;
use crate::linear::{Pivoted, RowMatrix, add, added, entries, vector};
use crate::scalar_state::changes_much;
use crate::singular::{ROUND_OFF, STILL, has_stalled};
use crate::sink::Discard;
use crate::yardstick::Yardstick;
use nalgebra::SVector;

const MAX_ITERATIONS: usize = 40;
/// J is singular, or not finite: with h → 0 it becomes M, so that a shorter step helps.
const SINGULAR: Fault = Fault::Flow {
    residual: f64::INFINITY,
    iterations: 0,
};

/// q₀ ⊕ h/2 (v₀ + v₁).
#[inline(always)]
pub(crate) fn trapezoid<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q0: &SVector<f64, Q>,
    v0: &SVector<f64, N>,
    v1: &SVector<f64, N>,
    h: f64,
) -> SVector<f64, Q> {
    system.advance(q0, &added(v0, 1.0, v1), 0.5 * h)
}

#[derive(Clone)]
pub(crate) struct Implicit<const N: usize> {
    h: f64,
    t1: f64,
    /// p₀ + h/2 F₀ and the other known terms of the momentum balance.
    pub(crate) known: SVector<f64, N>,
    /// J, factored.
    pub(crate) jacobian: Pivoted<N>,
    /// (∂p/∂q − h/2 ∂F/∂q) T, with the tangent T of ⊕.
    pub(crate) by_end: RowMatrix<N, N>,
    f_q: RowMatrix<N, N>,
    f_v: RowMatrix<N, N>,
    p_q: RowMatrix<N, N>,
    mass: RowMatrix<N, N>,
    force: SVector<f64, N>,
    momentum: SVector<f64, N>,
    /// Whether J is that of the present step.
    current: bool,
    /// The iteration ends where the next correction would be below this fraction of the velocities.
    pub(crate) negligible: f64,
}

impl<const N: usize> Implicit<N> {
    pub(crate) fn new() -> Self {
        Implicit {
            h: 0.0,
            t1: 0.0,
            known: SVector::zeros(),
            jacobian: Pivoted::new(),
            by_end: RowMatrix::zeros(),
            f_q: RowMatrix::zeros(),
            f_v: RowMatrix::zeros(),
            p_q: RowMatrix::zeros(),
            mass: RowMatrix::zeros(),
            force: SVector::zeros(),
            momentum: SVector::zeros(),
            current: false,
            negligible: ROUND_OFF,
        }
    }

    /// Begins a step of h that ends at t₁.
    pub(crate) fn begin(&mut self, t1: f64, h: f64) {
        (self.t1, self.h, self.current) = (t1, h, false);
    }

    /// Whether J has to be renewed before it is used.
    pub(crate) fn is_stale(&self) -> bool {
        !self.current
    }

    /// Marks J to be factored anew, because the iteration converges slowly.
    pub(crate) fn invalidate(&mut self) {
        self.current = false;
    }

    /// known ← p(q₀, v) + h/2 F(q₀, v).
    pub(crate) fn impulse<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        t0: f64,
        q0: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) {
        system.balance(t0, q0, v, &mut self.momentum, &mut self.force);
        for i in 0..N {
            self.known[i] = self.momentum[i] + 0.5 * self.h * self.force[i];
        }
    }

    /// ∂F/∂v at the start of the step.
    pub(crate) fn start_tangent<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        t0: f64,
        q0: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_v: &mut RowMatrix<N, N>,
    ) {
        let f_v = f_v.entries_mut();
        system.force_tangents(t0, q0, v, &mut Discard, f_v, &mut Discard);
    }

    /// known ← p(q₀, v_a) + h/2 F(q₀, v₀) of a step between kicks.
    pub(crate) fn impulse_on_rows<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        t0: f64,
        q0: &SVector<f64, Q>,
        [v0, va]: [&SVector<f64, N>; 2],
    ) {
        system.momentum(q0, va, &mut self.momentum);
        system.forces(t0, q0, v0, &mut self.force);
        for i in 0..N {
            self.known[i] = self.momentum[i] + 0.5 * self.h * self.force[i];
        }
    }

    /// −G at (q₁, v_b), the residual of the momentum balance.
    pub(crate) fn defect<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        q1: &SVector<f64, Q>,
        vb: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        system.balance(self.t1, q1, vb, &mut self.momentum, &mut self.force);
        self.residual()
    }

    /// The same with the force at v₁; the rows are then those at q₁.
    fn defect_on_rows<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        rows: &mut OnRows<N, R>,
        q1: &SVector<f64, Q>,
        vb: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, Fault> {
        rows.evaluate(system, self.t1, q1)?;
        let v1 = rows.velocities(system, vb);
        system.momentum(q1, vb, &mut self.momentum);
        system.forces(self.t1, q1, &v1, &mut self.force);
        Ok(self.residual())
    }

    fn residual(&self) -> SVector<f64, N> {
        let (known, momentum) = (entries(&self.known), entries(&self.momentum));
        let force = entries(&self.force);
        vector(|i| known[i] - momentum[i] + 0.5 * self.h * force[i])
    }

    /// J at (q₁, v_b) after a step that began with v_a, factored.
    pub(crate) fn refresh<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        q1: &SVector<f64, Q>,
        va: &SVector<f64, N>,
        vb: &SVector<f64, N>,
    ) -> Result<(), Fault> {
        self.tangents(system, q1, vb);
        self.factor::<S, Q, R>(va, vb, None)
    }

    /// The same with the force at v₁, of which ∂v₁/∂v_b = P. (p_q is that at v₁, and ∂v₁/∂q₁ is left out: the iteration corrects
    /// both.)
    pub(crate) fn refresh_on_rows<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        rows: &mut OnRows<N, R>,
        q1: &SVector<f64, Q>,
        [va, vb]: [&SVector<f64, N>; 2],
    ) -> Result<(), Fault> {
        self.tangents(system, q1, &rows.velocities(system, vb));
        self.factor::<S, Q, R>(va, vb, Some(rows.project(&self.f_v)))
    }

    fn tangents<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        q1: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) {
        let (mass, p_q) = (self.mass.entries_mut(), self.p_q.entries_mut());
        let (f_q, f_v) = (self.f_q.entries_mut(), self.f_v.entries_mut());
        system.balance_tangents(self.t1, q1, v, mass, f_q, f_v, p_q);
    }

    /// J of these tangents, with `f_v` in place of F_v.
    fn factor<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        va: &SVector<f64, N>,
        vb: &SVector<f64, N>,
        f_v: Option<&RowMatrix<N, N>>,
    ) -> Result<(), Fault> {
        let h = self.h;
        let (p_q, f_q) = (&self.p_q.data.0, &self.f_q.data.0);
        for (i, row) in self.by_end.entries_mut().iter_mut().enumerate() {
            for j in 0..N {
                row[j] = p_q[i][j] - 0.5 * h * f_q[i][j];
            }
        }
        if !S::ROTATIONS.is_empty() {
            let turn = vector(|i| 0.5 * h * (va[i] + vb[i]));
            pull_back::<S, Q, N, R>(&turn, &mut self.by_end);
        }
        let mut jacobian = *self.mass;
        let f_v = f_v.unwrap_or(&self.f_v);
        let (by_end, f_v) = (&self.by_end.data.0, &f_v.data.0);
        for (i, row) in jacobian.data.0.iter_mut().enumerate() {
            for j in 0..N {
                row[j] += 0.5 * h * (by_end[i][j] - f_v[i][j]);
            }
        }
        self.current = self.jacobian.factor(&jacobian);
        if self.current { Ok(()) } else { Err(SINGULAR) }
    }

    /// M₁ − h/2 F_v₁ as of the last J, factored: the metric in which the velocities of the step follow an impulse.
    pub(crate) fn velocity_metric(&self, metric: &mut Pivoted<N>) -> Result<(), Fault> {
        let mut matrix = *self.mass;
        let f_v = &self.f_v.data.0;
        for (i, row) in matrix.data.0.iter_mut().enumerate() {
            for j in 0..N {
                row[j] -= 0.5 * self.h * f_v[i][j];
            }
        }
        if metric.factor(&matrix) {
            Ok(())
        } else {
            Err(SINGULAR)
        }
    }

    /// Solves for v_b, starting from the one given, and returns q₁ = q₀ ⊕ h/2 (v_a + v_b). With `rows` the force is that
    /// at v₁.
    pub(crate) fn solve<S: System<Q, N, R>, const Q: usize, const R: usize>(
        &mut self,
        system: &S,
        yardstick: &Yardstick<Q, N>,
        q0: &SVector<f64, Q>,
        va: &SVector<f64, N>,
        vb: &mut SVector<f64, N>,
        mut rows: Option<&mut OnRows<N, R>>,
    ) -> Result<SVector<f64, Q>, Fault> {
        let mut last = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            let q1 = trapezoid(system, q0, va, vb, self.h);
            let fresh = !self.current;
            let mut change = match &mut rows {
                Some(rows) if const { S::STRUCTURE.velocity_forces && R > 0 } => {
                    let change = self.defect_on_rows(system, rows, &q1, vb)?;
                    if fresh {
                        self.refresh_on_rows(system, rows, &q1, [va, vb])?;
                    }
                    change
                }
                _ => {
                    let change = self.defect(system, &q1, vb);
                    if fresh {
                        self.refresh(system, &q1, va, vb)?;
                    }
                    change
                }
            };
            self.jacobian.solve(&mut change);
            add(vb, &change);
            let least = || yardstick.imperceptible(&q1, self.h) / self.negligible;
            let whole = || yardstick.measure(vb).max(least());
            let size = yardstick.correction(system.states(), (&change, vb), whole);
            let speed = yardstick.measure(vb);
            let stagnated = fresh
                && has_stalled(size, last)
                && size <= (STILL * speed).max(yardstick.imperceptible(&q1, self.h));
            // With this rate of convergence the next correction would be negligible.
            let rate = if last.is_finite() {
                (size / last).min(1.0)
            } else {
                1.0
            };
            let converged = size * rate <= self.negligible * speed;
            if converged || stagnated {
                return Ok(trapezoid(system, q0, va, vb, self.h));
            }
            if !size.is_finite() {
                return Err(Fault::NonFinite("velocities"));
            }
            // A chord that converges slowly is renewed.
            self.current = size < 0.1 * last && !changes_much(system.states(), &change, vb);
            last = size;
        }
        Err(Fault::Flow {
            residual: last,
            iterations: MAX_ITERATIONS,
        })
    }
}
