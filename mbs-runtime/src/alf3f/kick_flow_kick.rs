//! A stage: kick, flow, kick, in the form for the sorts of rows.

use super::step_context::StepContext;
use super::{kicks, mixed_kicks};
use crate::System;
use crate::fault::Fault;
use crate::flow::KickFlow;

/// One stage of h seconds.
#[inline(always)]
pub(super) fn kick_flow_kick<S, F, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    flow: &mut F,
    h: f64,
) -> Result<(), Fault>
where
    S: System<Q, N, R>,
    F: KickFlow<S, Q, N, R>,
{
    if const { S::STRUCTURE.holonomic_rows == R } {
        kicks::step(context, flow, h)
    } else {
        mixed_kicks::step(context, flow, h)
    }
}
