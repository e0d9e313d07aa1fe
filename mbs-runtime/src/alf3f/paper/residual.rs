//! The residuals of the equations (75) and of the rows, and the test of line 32 of Algorithm 1.

use super::PaperStepper;
use super::rows::{RowMotion, Unknowns};
use crate::System;
use crate::linear::{dot, largest, vector};
use nalgebra::SVector;

/// The residual ψ̇ after Newton's iteration, relative to its tolerance: the last correction reduces the one before by
/// more than this factor.
const NEWTON_NOISE: f64 = 1e-2;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> PaperStepper<S, Q, N, R> {
    /// Line 32: whether the residual ℜ and the rows hold for the updated q₁ and λ₁.
    pub(super) fn is_settled(
        &mut self,
        t1: f64,
        h: f64,
        known: &SVector<f64, N>,
        x: &Unknowns<Q, N, R>,
    ) -> bool {
        let defects = self.defects(h, &x.v);
        if !(largest(&defects) <= self.settings.velocity_tolerance) {
            return false;
        }
        let mu: SVector<f64, R> = vector(|r| x.mu[r] - x.penalty[r] * defects[r]);
        let lambda = self.lifted_lambda(h, x, &mu);
        let residual = self.residual(t1, h, known, x, &mu, &lambda);
        let size = |x: &SVector<f64, N>| {
            let mut y = *x;
            self.system.solve_mass(&self.end.geometry.mass, &mut y);
            dot(x, &y).sqrt()
        };
        let scale = dot(self.end.mechanical_momentum(), &x.v).sqrt() + h * size(self.end.force());
        // Newton's method leaves a residual ψ̇, which is multiplied by the penalty: a smaller ℜ cannot be reached.
        let floor = NEWTON_NOISE * self.settings.newton_tolerance * self.heaviest_penalty(h, x);
        let bound = self.settings.residual_tolerance.max(floor) * scale;
        // A loop that diverges ends with ∞ on both sides.
        bound.is_finite() && size(&residual) <= bound
    }

    /// The largest penalty, in rows of unit effective mass.
    fn heaviest_penalty(&self, h: f64, x: &Unknowns<Q, N, R>) -> f64 {
        let weights = (0..R).map(|r| match self.motion {
            RowMotion::Own => x.penalty[r],
            RowMotion::Static => 0.25 * h * h * x.penalty[r] * self.end.geometry.delassus[r][r],
        });
        weights.fold(0.0, f64::max)
    }

    /// The residuals of the rows over a step, as velocities: ψ̇ where a row has no stiffness of its own, else the
    /// discrete form of (31), [m̄ψ̇] + h/2 Σ (c̄ψ̇ + k̄φ) divided by m̄ + h/2 c̄. The latter allows φ ≠ 0 and reduces
    /// it.
    pub(super) fn defects(&self, h: f64, v: &SVector<f64, N>) -> SVector<f64, R> {
        let (start, end) = (&self.start, &self.end);
        let rates = end.geometry.velocity_rows(&self.system, v);
        if !self.solves_row_motion() {
            return rates;
        }
        let before = start
            .geometry
            .velocity_rows(&self.system, &self.state.velocities);
        vector(|i| {
            let inertia = end.constraint_mass[i] + 0.5 * h * end.constraint_damping[i];
            let known = (0.5 * h * start.constraint_damping[i] - start.constraint_mass[i])
                * before[i]
                + 0.5 * h * start.constraint_stiffness[i] * start.phi[i];
            let stiff = 0.5 * h * end.constraint_stiffness[i] * end.phi[i];
            rates[i] + (known + stiff) / inertia
        })
    }

    fn solves_row_motion(&self) -> bool {
        self.motion == RowMotion::Own && self.settings.stabilisation_frequency > 0.0
    }

    /// λ̄ of (74); for M-ALF λ with the rate μ̄ at the end of the step.
    pub(super) fn lifted_lambda(
        &self,
        h: f64,
        x: &Unknowns<Q, N, R>,
        mu: &SVector<f64, R>,
    ) -> SVector<f64, R> {
        vector(|r| match self.motion {
            RowMotion::Own if self.solves_row_motion() => x.lambda[r],
            RowMotion::Own => x.lambda[r] - x.penalty[r] * self.end.phi[r],
            RowMotion::Static => x.lambda[r] + 0.5 * h * (mu[r] - x.mu[r]),
        })
    }

    /// −η(v₁) of (75) with these multipliers.
    pub(super) fn residual(
        &mut self,
        t1: f64,
        h: f64,
        known: &SVector<f64, N>,
        x: &Unknowns<Q, N, R>,
        mu: &SVector<f64, R>,
        lambda: &SVector<f64, R>,
    ) -> SVector<f64, N> {
        let (system, end) = (&self.system, &mut self.end);
        let force = end.total_force(system, t1, &x.q, &x.v, mu, lambda);
        let momentum = end.momentum(system, &x.q, &x.v, mu);
        vector(|n| known[n] + 0.5 * h * force[n] - momentum[n])
    }
}
