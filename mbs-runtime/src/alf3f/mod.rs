//! ALF-3F: the two-level step and the paper's Algorithm 1.

mod composition;
mod core;
mod fault;
mod implicit_step;
mod kicks;
mod landings;
mod mixed_kicks;
mod node;
mod paper;
mod passage;
mod sparse_kicks;
mod two_level;

pub(crate) use self::core::{Counters, FIXED_REFINEMENTS, RowScale};
pub(crate) use composition::{ORDERS, stages};
pub(crate) use fault::Fault;
pub(crate) use kicks::{not_converged, residual_of};
pub(crate) use landings::{CLEAR, Landings};
pub(crate) use node::Node;
pub use paper::{MultiplierStart, PaperSettings, PaperStepper, RowDirection};
pub(crate) use passage::Passage;
pub use two_level::TwoLevelStepper;
