//! Integrators of the literature on the same generated equations, for comparison.
//!
//! Each has the form of its source and the settings that its users would choose; they share linear algebra and
//! diagnostics with the two-level method.

mod adaptive;
mod baumgarte;
mod bdf;
mod bdf_history;
mod bench;
mod complex_saddle;
mod generalized_alpha;
mod index1;
mod index3_projections;
mod motion;
mod penalty;
mod planned;
mod planned_proximal;
mod projection;
mod radau;
mod radau_coefficients;
mod radau_errors;
mod radau_memory;
mod rattle;
pub(crate) mod registry;
mod rule;
mod runge_kutta;
mod saddle;
mod stage_poses;
mod stepper;
mod tableau;

pub(crate) use baumgarte::Explicit;
pub(crate) use bdf::Bdf;
pub(crate) use bench::Works;
pub(crate) use generalized_alpha::GeneralizedAlpha;
pub(crate) use index3_projections::Index3;
pub(crate) use penalty::Penalty;
pub(crate) use radau::Radau;
pub(crate) use rattle::Rattle;
pub use stepper::BaselineStepper;
