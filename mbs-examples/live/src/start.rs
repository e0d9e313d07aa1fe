//! Which methods are compiled for the scenes: those that the page compares.

use mbs_runtime::{
    AnySimulation, Mechanism, Method, Settings, Simulation, SimulationError, System, methods,
};

/// A simulation of a scene, with a method of [`METHODS`](crate::METHODS).
pub(crate) fn start<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
) -> Result<Box<dyn AnySimulation>, SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let simulation = match settings.method {
        Method::Baumgarte(_) => Simulation::with_methods(mechanism, settings, methods::Baumgarte)?,
        Method::Projected => Simulation::with_methods(mechanism, settings, methods::Projected)?,
        Method::Rattle => Simulation::with_methods(mechanism, settings, methods::Rattle)?,
        Method::GeneralizedAlpha(_) => {
            Simulation::with_methods(mechanism, settings, methods::GeneralizedAlpha)?
        }
        Method::Index3Projections(_) => {
            Simulation::with_methods(mechanism, settings, methods::Index3Projections)?
        }
        Method::Penalty(_) => Simulation::with_methods(mechanism, settings, methods::Penalty)?,
        // The two-level method; any other is not compiled.
        _ => Simulation::with_settings(mechanism, settings)?,
    };
    Ok(Box::new(simulation))
}
