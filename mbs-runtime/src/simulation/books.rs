//! Sums over the steps of a run.

use crate::alf3f::Counters;

/// What steps add up beside the state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Books {
    pub(super) steps: u64,
    /// The shortest step since the beginning of the last whole one, s.
    pub(super) shortest: f64,
    /// The largest so far, as in [`Report`](crate::Report).
    pub(super) energy_error: f64,
    pub(super) holonomic_error: f64,
    pub(super) velocity_error: f64,
    /// Power of nonconservative forces at the current instant, W.
    pub(super) power: f64,
}

impl Books {
    /// Before the first step.
    pub(super) const EMPTY: Books = Books {
        steps: 0,
        shortest: f64::INFINITY,
        energy_error: 0.0,
        holonomic_error: 0.0,
        velocity_error: 0.0,
        power: 0.0,
    };
}

impl Counters {
    /// The sum.
    pub(super) fn and(self, other: Counters) -> Counters {
        Counters {
            stages: self.stages + other.stages,
            iterations: self.iterations + other.iterations,
            regularised: self.regularised + other.regularised,
            rejected: self.rejected + other.rejected,
        }
    }
}
