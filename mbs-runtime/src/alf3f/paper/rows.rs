//! The constraints as in the paper: rows with mass, damping and stiffness of their own, (18)–(20).

use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{RowMatrix, dot};
use crate::sink::Discard;
use crate::{PaperSettings, RowDirection};
use nalgebra::SVector;

/// The equation of motion that each row has, (16).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum RowMotion {
    /// m̄, c̄, k̄ and f̄ of (18)–(20): ALF-3F.
    Own,
    /// m̄ = c̄ = f̄ = 0 and k̄ = 1 in (16), m̄ = 1 in (22): the modified augmented Lagrangian (M-ALF) of section 7.2, as
    /// formulations before had it. λ is the force of the row.
    Static,
}

/// The unknowns at the end of a step.
pub(super) struct Unknowns<const Q: usize, const N: usize, const R: usize> {
    pub(super) v: SVector<f64, N>,
    pub(super) q: SVector<f64, Q>,
    pub(super) mu: SVector<f64, R>,
    pub(super) lambda: SVector<f64, R>,
    pub(super) penalty: SVector<f64, R>,
}

/// One instant of Algorithm 1.
#[derive(Clone)]
pub(super) struct Instant<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    motion: RowMotion,
    pub(super) geometry: Box<ConstraintGeometry<S, Q, N, R>>,
    pub(super) phi: SVector<f64, R>,
    /// m̄ of (18), times the scale of the settings.
    pub(super) constraint_mass: SVector<f64, R>,
    /// c̄ of (20).
    pub(super) constraint_damping: SVector<f64, R>,
    /// k̄ of (20); zero for nonholonomic rows.
    pub(super) constraint_stiffness: SVector<f64, R>,
    /// c_R of (19), row by row.
    direction: RowMatrix<N, R>,
    mass: RowMatrix<N, N>,
    /// Ȧ along v.
    a_rate: RowMatrix<N, R>,
    /// f, the applied forces.
    applied: SVector<f64, N>,
    /// f + ∂T/∂q.
    force: SVector<f64, N>,
    momentum: SVector<f64, N>,
    f_q: RowMatrix<N, N>,
    pub(super) f_v: RowMatrix<N, N>,
    scratch: SVector<f64, R>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Instant<S, Q, N, R> {
    pub(super) fn new(system: &S, q: &SVector<f64, Q>, motion: RowMotion) -> Result<Self, Fault> {
        Ok(Instant {
            motion,
            geometry: ConstraintGeometry::new(system, q)?,
            phi: SVector::zeros(),
            constraint_mass: SVector::zeros(),
            constraint_damping: SVector::zeros(),
            constraint_stiffness: SVector::zeros(),
            direction: RowMatrix::zeros(),
            mass: RowMatrix::zeros(),
            a_rate: RowMatrix::zeros(),
            applied: SVector::zeros(),
            force: SVector::zeros(),
            momentum: SVector::zeros(),
            f_q: RowMatrix::zeros(),
            f_v: RowMatrix::zeros(),
            scratch: SVector::zeros(),
        })
    }

    /// Geometry and coefficients at (t, q); v enters through the force tangents only.
    pub(super) fn place(
        &mut self,
        system: &S,
        settings: &PaperSettings,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<(), Fault> {
        let Instant { geometry, phi, .. } = self;
        system.constraints(t, q, phi, geometry.a.entries_mut(), &mut geometry.b);
        geometry.metric(system, t, q)?;
        system.applied_force_tangents(t, q, v, &mut self.f_q, &mut self.f_v);
        if self.motion == RowMotion::Static {
            self.constraint_stiffness = SVector::repeat(1.0);
            return Ok(());
        }
        if settings.direction == RowDirection::Euclidean {
            system.mass_matrix(q, &mut self.mass);
        }
        let omega = settings.stabilisation_frequency;
        for i in 0..R {
            let length_squared = self.geometry.delassus[i][i];
            if !(length_squared > 0.0) {
                return Err(Fault::Row {
                    row: i,
                    residual: length_squared,
                    iterations: 0,
                });
            }
            let direction = match settings.direction {
                RowDirection::Metric => self.geometry.w[i].map(|w| w / length_squared),
                RowDirection::Euclidean => {
                    let row = &self.geometry.a[i];
                    let square = dot(row, row);
                    row.map(|a| a / square)
                }
            };
            let mass = settings.mass_scale
                * match settings.direction {
                    RowDirection::Metric => 1.0 / length_squared,
                    RowDirection::Euclidean => quadratic(&self.mass, &direction),
                };
            self.constraint_mass[i] = mass;
            self.constraint_damping[i] = 2.0 * mass * omega - quadratic(&self.f_v, &direction);
            self.constraint_stiffness[i] = if i < S::STRUCTURE.holonomic_rows {
                mass * omega * omega - quadratic(&self.f_q, &direction)
            } else {
                0.0
            };
            self.direction[i] = direction;
        }
        Ok(())
    }

    /// F = f + ∂T/∂q + Aᵀ(C̄μ + K̄λ − f̄) − Ȧᵀ M̄ μ.
    pub(super) fn total_force(
        &mut self,
        system: &S,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        mu: &SVector<f64, R>,
        lambda: &SVector<f64, R>,
    ) -> SVector<f64, N> {
        system.applied_forces(t, q, v, &mut self.applied);
        system.forces(t, q, v, &mut self.force);
        system.constraint_rates(t, q, v, &mut self.a_rate, &mut self.scratch);
        let mut total = self.force;
        for i in 0..R {
            let force = self.row_force(i, mu, lambda);
            let momentum = self.constraint_mass[i] * mu[i];
            for j in 0..N {
                total[j] += force * self.geometry.a[i][j] - momentum * self.a_rate[i][j];
            }
        }
        total
    }

    /// M v of the last `momentum`.
    pub(super) fn mechanical_momentum(&self) -> &SVector<f64, N> {
        &self.momentum
    }

    /// f + ∂T/∂q of the last `total_force`.
    pub(super) fn force(&self) -> &SVector<f64, N> {
        &self.force
    }

    /// c̄μ + k̄λ − f̄ of a row, with the f of the last `total_force`.
    pub(super) fn row_force(
        &self,
        i: usize,
        mu: &SVector<f64, R>,
        lambda: &SVector<f64, R>,
    ) -> f64 {
        if self.motion == RowMotion::Static {
            return lambda[i];
        }
        self.constraint_damping[i] * mu[i] + self.constraint_stiffness[i] * lambda[i]
            - dot(&self.direction[i], &self.applied)
    }

    /// π = M v − Aᵀ M̄ μ, (26).
    pub(super) fn momentum(
        &mut self,
        system: &S,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        mu: &SVector<f64, R>,
    ) -> SVector<f64, N> {
        system.momentum(q, v, &mut self.momentum);
        let mut momentum = self.momentum;
        for i in 0..R {
            let share = self.constraint_mass[i] * mu[i];
            for j in 0..N {
                momentum[j] -= share * self.geometry.a[i][j];
            }
        }
        momentum
    }

    /// J = M + Aᵀ(M̄ + h/2 C̄)ΞA − h/2 ∂f/∂v, (79); with h²/4 K̄ in place of M̄ and C̄ where rows have none.
    pub(super) fn jacobian(
        &self,
        system: &S,
        t: f64,
        h: f64,
        x: &Unknowns<Q, N, R>,
        jacobian: &mut Jacobian<N>,
    ) {
        system.mass_matrix(&x.q, &mut jacobian.mass);
        // ∂F/∂v instead of ∂f/∂v: the quadratic terms depend on v as well.
        system.force_tangents(t, &x.q, &x.v, &mut Discard, &mut jacobian.f_v, &mut Discard);
        *jacobian.total = *jacobian.mass;
        for i in 0..N {
            for j in 0..N {
                jacobian.total[i][j] -= 0.5 * h * jacobian.f_v[i][j];
            }
        }
        for r in 0..R {
            let row = &self.geometry.a[r];
            let weight = match self.motion {
                RowMotion::Own => self.constraint_mass[r] + 0.5 * h * self.constraint_damping[r],
                RowMotion::Static => 0.25 * h * h * self.constraint_stiffness[r],
            } * x.penalty[r];
            for i in 0..N {
                if row[i] == 0.0 {
                    continue;
                }
                for j in 0..N {
                    jacobian.total[i][j] += weight * row[i] * row[j];
                }
            }
        }
    }
}

/// Storage of J.
#[derive(Clone)]
pub(super) struct Jacobian<const N: usize> {
    mass: RowMatrix<N, N>,
    f_v: RowMatrix<N, N>,
    pub(super) total: RowMatrix<N, N>,
}

impl<const N: usize> Jacobian<N> {
    pub(super) fn new() -> Self {
        Jacobian {
            mass: RowMatrix::zeros(),
            f_v: RowMatrix::zeros(),
            total: RowMatrix::zeros(),
        }
    }
}

/// xᵀ m x.
fn quadratic<const N: usize>(m: &RowMatrix<N, N>, x: &SVector<f64, N>) -> f64 {
    (0..N).map(|i| x[i] * dot(&m[i], x)).sum()
}
