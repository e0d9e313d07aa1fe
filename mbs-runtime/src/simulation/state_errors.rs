//! The errors of states in pairs of steps.
//!
//! They are relative to the size of the state, and allowed as the motion goes on:
//!
//! ```text
//! e ≤ share · tolerance · max(way of the mechanism, largest relative change of a state)
//! ```

use super::Simulation;
use crate::scalar_state::relative;
use crate::{ScalarState, System};

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The largest distance of a state after the other steps from that after the pair, as a multiple of what is allowed
    /// after a way of the mechanism and is at least `noise`; and the velocity that it is.
    pub(super) fn state_error_ratio(
        &self,
        (share, way): (f64, f64),
        noise: f64,
    ) -> Option<(f64, usize)> {
        let [begin, end, other] =
            [&*self.pair_start, &*self.pair_end, self.state()].map(|state| &state.velocities);
        let of = |state: &ScalarState, from, to| {
            let change = to - from;
            relative(core::slice::from_ref(state), &change, end)
        };
        let changes = S::STATES.iter().map(|state| of(state, begin, end));
        let allowed = (share * changes.fold(way, f64::max)).max(noise);
        let apart = S::STATES
            .iter()
            .map(|state| (of(state, end, other) / allowed, state.velocity));
        apart.max_by(|(one, _), (other, _)| one.total_cmp(other))
    }
}
