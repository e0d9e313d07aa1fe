//! Inputs that were refused.

use crate::SimulationError;

/// The values that were given, of which at least one is not finite or leads where no pose satisfies the rows, and the error.
#[derive(Debug, Clone)]
pub(super) struct Refused<I> {
    pub(super) error: SimulationError,
    pub(super) inputs: I,
}
