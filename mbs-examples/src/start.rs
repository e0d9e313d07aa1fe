//! Which methods are compiled for the scenes.

use mbs_runtime::{
    AnySimulation, Mechanism, Settings, Simulation, SimulationError, System, methods,
};

/// A simulation of a scene: with any method in builds with the feature `laboratory`, otherwise with those of which an
/// accuracy chooses one.
///
/// # Errors
/// As [`Simulation::with_methods`].
pub fn start<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
) -> Result<Box<dyn AnySimulation>, SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    #[cfg(feature = "laboratory")]
    let compiled = methods::Any;
    #[cfg(not(feature = "laboratory"))]
    let compiled = methods::Accuracy;
    let simulation = Simulation::with_methods(mechanism, settings, compiled)?;
    Ok(Box::new(simulation))
}
