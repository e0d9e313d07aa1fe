//! Which methods are compiled for the scenes.

use mbs_runtime::{AnySimulation, Mechanism, Settings, Simulation, SimulationError, System};

/// A simulation of a scene: with any method in builds with the feature `laboratory`, otherwise with the two-level one.
///
/// # Errors
/// As [`Simulation::with_any_method`], or [`Simulation::with_settings`].
pub fn start<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
) -> Result<Box<dyn AnySimulation>, SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    #[cfg(feature = "laboratory")]
    let simulation = Simulation::with_any_method(mechanism, settings)?;
    #[cfg(not(feature = "laboratory"))]
    let simulation = Simulation::with_settings(mechanism, settings)?;
    Ok(Box::new(simulation))
}
