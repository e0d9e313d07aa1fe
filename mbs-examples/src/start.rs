//! Which methods are compiled for the scenes.

use mbs_runtime::{AnySimulation, Mechanism, Settings, Simulation, SimulationError, System};

/// A simulation of a scene, with any method.
///
/// # Errors
/// As [`Simulation::with_any_method`].
pub fn start<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
) -> Result<Box<dyn AnySimulation>, SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    Ok(Box::new(Simulation::with_any_method(mechanism, settings)?))
}
