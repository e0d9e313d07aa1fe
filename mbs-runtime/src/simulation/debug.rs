//! Simulations and what is made of them in messages: the mechanism and its state, without workspaces.

use super::{InputsMut, Simulation};
use crate::System;
use std::fmt;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> fmt::Debug
    for Simulation<S, Q, N, R>
{
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Simulation")
            .field("mechanism", &S::MODEL.name)
            .field("time", &self.time())
            .field("positions", &self.positions().as_slice())
            .field("velocities", &self.velocities().as_slice())
            .field("settings", &self.settings)
            .finish_non_exhaustive()
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> fmt::Debug
    for InputsMut<'_, S, Q, N, R>
{
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, out)
    }
}
