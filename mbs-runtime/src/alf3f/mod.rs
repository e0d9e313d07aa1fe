//! ALF-3F: the two-level step and the paper's Algorithm 1.

pub(crate) mod closing;
mod composition;
mod corrections;
mod embedded;
mod extrapolation;
mod implicit_step;
mod kick_flow_kick;
mod kicks;
pub(crate) mod large;
mod mixed_kicks;
#[cfg(feature = "std")]
mod paper;
#[cfg(feature = "std")]
pub(crate) mod sparse;
#[cfg(feature = "std")]
mod sparse_kicks;
#[cfg(not(feature = "std"))]
#[path = "sparse_kicks/absent.rs"]
mod sparse_kicks;
mod stage_placement;
mod step_context;
mod step_monitor;
mod stepping;
mod two_level;

pub(crate) use self::step_context::{Counters, FIXED_REFINEMENTS};
pub(crate) use closing::{not_converged, residual_of};
#[cfg(feature = "std")]
pub use paper::PaperStepper;
pub(crate) use stage_placement::{CLEAR, LACK, ROOM, StagePlacement};
pub(crate) use step_monitor::StepMonitor;
pub use two_level::TwoLevelStepper;
