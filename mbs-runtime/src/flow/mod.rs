//! Symmetric second-order flows without constraints, (q₁, v_b) = Φ_h(q₀, v_a).

mod choice;
mod drift;
mod group;
mod implicit;
mod leapfrog;
mod midpoint;
mod on_rows;
mod trapezoid;

use crate::linear::RowMatrix;
pub(crate) use choice::choose;
#[cfg(feature = "sparse")]
pub(crate) use group::right_tangent;
pub(crate) use group::{pull_back, pull_back_rows, transport, unroll};
pub(crate) use implicit::{Implicit, trapezoid};
pub(crate) use leapfrog::Leapfrog;
pub(crate) use midpoint::Midpoint;
use nalgebra::SVector;
pub(crate) use trapezoid::Trapezoid;

use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;

/// A flow between two kicks.
pub(crate) trait KickFlow<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    /// Begins a step of h = t₁ − t₀ from q₀ and v₀, with the first guess of the kicked velocity v_a.
    fn begin(
        &mut self,
        system: &S,
        times: [f64; 2],
        q: &SVector<f64, Q>,
        velocities: [&SVector<f64, N>; 2],
        start: &ConstraintGeometry<S, Q, N, R>,
        h: f64,
    );
    /// Whether ∂q₁/∂v_a is h I, or hardly differs, so that B is close to A₀M⁻¹A₀ᵀ.
    fn is_direct(&self) -> bool;
    /// q₁ for the kicked velocity v_a.
    fn positions(
        &mut self,
        system: &S,
        va: &SVector<f64, N>,
        q: &mut SVector<f64, Q>,
    ) -> Result<(), Fault>;
    /// Row by row (∂q₁/∂v_a) w / h for the rows w of W at the start.
    fn position_sensitivity<'a>(
        &'a mut self,
        system: &S,
        va: &SVector<f64, N>,
        start: &'a ConstraintGeometry<S, Q, N, R>,
    ) -> Result<&'a RowMatrix<N, R>, Fault>;
    /// Row by row (∂v_b/∂v_a) w, after `directions` for the same rows.
    fn velocity_sensitivity<'a>(&'a self, w0: &'a RowMatrix<N, R>) -> Option<&'a RowMatrix<N, R>>;
    /// The multipliers, and with them v_a, are about to change by `change`.
    fn predict(&mut self, change: &SVector<f64, R>);
    /// v_b, where `end` has the metric of the end already; stores the quantities of the end for the next step.
    fn velocities(
        &mut self,
        system: &S,
        va: &SVector<f64, N>,
        q1: &SVector<f64, Q>,
        end: &mut ConstraintGeometry<S, Q, N, R>,
    ) -> SVector<f64, N>;
}
