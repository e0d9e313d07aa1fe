//! ALF-3F: the two-level step and the paper's Algorithm 1.

pub(crate) mod closing;
mod composition;
mod corrections;
mod extrapolation;
mod implicit_step;
mod kick_flow_kick;
mod kicks;
pub(crate) mod large;
mod mixed_kicks;
mod paper;
pub(crate) mod sparse;
mod sparse_kicks;
mod stage_placement;
mod step_context;
mod step_monitor;
mod two_level;

pub(crate) use self::step_context::{Counters, FIXED_REFINEMENTS};
pub(crate) use closing::{not_converged, residual_of};
pub use paper::PaperStepper;
pub(crate) use stage_placement::{CLEAR, StagePlacement};
pub(crate) use step_monitor::StepMonitor;
pub use two_level::TwoLevelStepper;
