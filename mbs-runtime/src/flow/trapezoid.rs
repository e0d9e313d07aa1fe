//! Implicit trapezoid in momentum form: M(q), and forces that are stiff in the positions.
//!
//! ```text
//! G = p(q₁, v_b) − p(q₀, v_a) − h/2 (F(q₀, v_a) + F(q₁, v_b)) = 0,    q₁ = q₀ ⊕ h/2 (v_a + v_b)
//! J =  ∂G/∂v_b = M₁ + h/2 (p_q₁ − h/2 F_q₁) T − h/2 F_v₁
//! K = −∂G/∂v_a = M₀ − h/2 (p_q₁ − h/2 F_q₁) T + h/2 F_v₀
//! ```
//!
//! Beside rows, forces that depend on velocities are those at v₀ and v₁, before and after the kicks:
//!
//! ```text
//! G = p(q₁, v_b) − p(q₀, v_a) − h/2 (F(q₀, v₀) + F(q₁, v₁)),    v₁ = P v_b − W₁ S₁⁻¹ b₁
//! ```
//!
//! with F_v₁P in place of F_v₁ in J, and without F_v₀ in K. A kick is h/2 times the accelerations that the rows prevent: it
//! takes a light body beside a friction to many times the regularization velocity, where its force is another one.
//!
//! F = f + ∂T/∂q holds the affinities; T, the tangent of ⊕, is I but for rotations. The multipliers of the first kick
//! change q₁ by ∂q₁/∂v_a = h/2 T (I + J⁻¹K); with h I instead the iteration fails with stiff springs.

use super::KickFlow;
use super::group::transport;
use super::implicit::Implicit;
use super::on_rows::OnRows;
use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{DelassusFactor, RowMatrix, entries, entries_mut, vector};
use crate::memory::Box;
use crate::yardstick::Yardstick;
use nalgebra::SVector;

#[derive(Clone)]
pub(crate) struct Trapezoid<const Q: usize, const N: usize, const R: usize> {
    h: f64,
    t0: f64,
    q0: SVector<f64, Q>,
    q1: SVector<f64, Q>,
    v0: SVector<f64, N>,
    vb: SVector<f64, N>,
    solver: Implicit<N>,
    /// For forces that depend on velocities, beside rows.
    on_rows: Option<Box<OnRows<N, R>>>,
    yardstick: Yardstick<Q, N>,
    /// F_v₀.
    by_velocity: RowMatrix<N, N>,
    /// (∂v_b/∂v_a) w, row by row.
    far: RowMatrix<N, R>,
    /// (∂q₁/∂v_a) w / h, row by row.
    directions: RowMatrix<N, R>,
}

impl<const Q: usize, const N: usize, const R: usize> Trapezoid<Q, N, R> {
    /// With the factor of S, where forces depend on velocities beside rows.
    #[inline(never)]
    pub(crate) fn new(
        yardstick: &Yardstick<Q, N>,
        beside: Option<&DelassusFactor<R>>,
    ) -> Box<Self> {
        Box::new(Trapezoid {
            h: 0.0,
            t0: 0.0,
            q0: SVector::zeros(),
            q1: SVector::zeros(),
            v0: SVector::zeros(),
            vb: SVector::zeros(),
            solver: Implicit::new(),
            on_rows: beside.map(OnRows::new),
            yardstick: *yardstick,
            by_velocity: RowMatrix::zeros(),
            far: RowMatrix::zeros(),
            directions: RowMatrix::zeros(),
        })
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> KickFlow<S, Q, N, R>
    for Trapezoid<Q, N, R>
{
    fn begin(
        &mut self,
        _: &S,
        [t0, t1]: [f64; 2],
        q: &SVector<f64, Q>,
        [v0, va]: [&SVector<f64, N>; 2],
        _: &ConstraintGeometry<S, Q, N, R>,
        h: f64,
    ) {
        (self.h, self.t0, self.q0, self.v0, self.vb) = (h, t0, *q, *v0, *va);
        self.solver.begin(t1, h);
    }

    fn is_direct(&self) -> bool {
        false
    }

    fn positions(
        &mut self,
        system: &S,
        va: &SVector<f64, N>,
        q: &mut SVector<f64, Q>,
    ) -> Result<(), Fault> {
        let (yardstick, q0) = (&self.yardstick, &self.q0);
        match &self.on_rows {
            Some(_) => (self.solver).impulse_on_rows(system, self.t0, q0, [&self.v0, va]),
            None => self.solver.impulse(system, self.t0, q0, va),
        }
        let rows = self.on_rows.as_deref_mut();
        *q = (self.solver).solve(system, yardstick, q0, va, &mut self.vb, rows)?;
        self.q1 = *q;
        Ok(())
    }

    fn position_sensitivity<'a>(
        &'a mut self,
        system: &S,
        va: &SVector<f64, N>,
        start: &'a ConstraintGeometry<S, Q, N, R>,
    ) -> Result<&'a RowMatrix<N, R>, Fault> {
        // Without rows nobody asks; the return keeps rustc from compiling the rest.
        if const { R == 0 } {
            return Ok(&self.directions);
        }
        let h = self.h;
        // The tangent is that at the end; its factors are used for the first correction of the next iteration.
        let f_v = &mut self.by_velocity;
        if let Some(rows) = &mut self.on_rows {
            (self.solver).refresh_on_rows(system, rows, &self.q1, [va, &self.vb])?;
        } else {
            self.solver.refresh(system, &self.q1, va, &self.vb)?;
            (self.solver).start_tangent(system, self.t0, &self.q0, va, f_v);
        }
        for r in 0..R {
            let w = &start.w.data.0[r];
            let (f_v, by_end) = (&f_v.data.0, &self.solver.by_end.data.0);
            // M₀ w is the row of A₀ that w came from.
            let mut far = start.a[r];
            for (i, far) in entries_mut(&mut far).iter_mut().enumerate() {
                let mut sum = 0.0;
                for j in 0..N {
                    sum += (f_v[i][j] - by_end[i][j]) * w[j];
                }
                *far += 0.5 * h * sum;
            }
            self.solver.jacobian.solve(&mut far);
            self.far[r] = far;
            let far = entries(&far);
            self.directions[r] = vector(|i| 0.5 * (w[i] + far[i]));
        }
        if !S::ROTATIONS.is_empty() {
            let turn = vector(|i| 0.5 * h * (va[i] + self.vb[i]));
            transport::<S, Q, N, R>(&turn, self.directions.rows_mut());
        }
        Ok(&self.directions)
    }

    fn velocity_sensitivity<'a>(&'a self, _: &'a RowMatrix<N, R>) -> Option<&'a RowMatrix<N, R>> {
        Some(&self.far)
    }

    fn predict(&mut self, change: &SVector<f64, R>) {
        crate::linear::accumulate(&mut self.vb, &self.far, change);
    }

    fn velocities(
        &mut self,
        _: &S,
        _: &SVector<f64, N>,
        _: &SVector<f64, Q>,
        _: &mut ConstraintGeometry<S, Q, N, R>,
    ) -> SVector<f64, N> {
        self.vb
    }
}
