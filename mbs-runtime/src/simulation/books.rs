//! Sums over the steps of a run.

/// What steps add up beside the state.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Books {
    pub(super) steps: u64,
    /// The largest so far, as in [`Report`](crate::Report).
    pub(super) energy_error: f64,
    pub(super) holonomic_error: f64,
    pub(super) velocity_error: f64,
    /// Power of nonconservative forces at the current instant, W.
    pub(super) power: f64,
}
