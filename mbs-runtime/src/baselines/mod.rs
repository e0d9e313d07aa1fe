//! Integrators of the literature on the same generated equations, for comparison.
//!
//! Each has the form of its source and the settings that its users would choose; they share linear algebra and
//! diagnostics with the two-level method.

mod adaptive;
mod baumgarte;
mod bdf;
mod bdf_history;
mod bench;
mod generalized_alpha;
mod index1;
mod index3_projections;
mod motion;
mod penalty;
mod rattle;
mod runge_kutta;
mod saddle;
mod stepper;
mod tableau;

pub(crate) use bench::Works;
pub use stepper::BaselineStepper;
