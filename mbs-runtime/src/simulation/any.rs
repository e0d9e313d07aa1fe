//! The object-safe form of every simulation.

use crate::any::methods_of_any_simulation;
use crate::{
    AnySimulation, AssemblyVerdict, Energy, Flow, MethodChange, Model, RankLoss, Reactions, Report,
    Sample, Settings, Simulation, SimulationError, System, UnknownName,
};

macro_rules! implement {
    ($($(#[doc = $doc:literal])* fn $name:ident(&$($mutable:ident)? $(, $argument:ident: $kind:ty)*) -> $result:ty;)*) => {
        impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> AnySimulation
            for Simulation<S, Q, N, R>
        {
            $(fn $name(&$($mutable)? self $(, $argument: $kind)*) -> $result {
                Simulation::$name(self $(, $argument)*)
            })*
            fn coordinates(&self) -> Vec<f64> {
                self.positions().as_slice().to_vec()
            }
            fn velocities(&self) -> Vec<f64> {
                Simulation::velocities(self).as_slice().to_vec()
            }
        }
    };
}

methods_of_any_simulation!(implement);
