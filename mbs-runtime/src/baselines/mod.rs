//! Integrators of the literature on the same generated equations, as a yardstick.
//!
//! Each is in the form its source gives and tuned as its users would; they share linear algebra and diagnostics with the
//! two-level method.

mod adaptive;
mod baumgarte;
mod bench;
mod index1;
mod runge_kutta;
mod stepper;
mod tableau;

pub use baumgarte::BaumgarteSettings;
pub(crate) use bench::Works;
pub use stepper::BaselineStepper;
