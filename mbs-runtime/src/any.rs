//! An object-safe trait for simulations, for programs that choose the mechanism at run time.

use crate::{
    AssemblyVerdict, Energy, Flow, MethodChange, Model, RankLoss, Reactions, Report, Sample,
    Settings, SimulationError, UnknownName,
};

/// Passes the methods of [`AnySimulation`] that every simulation has under the same name to a macro.
macro_rules! methods_of_any_simulation {
    ($macro:ident) => {
        $macro! {
            /// The summary of the model.
            fn model(&) -> &'static Model;
            /// The settings.
            fn settings(&) -> &Settings;
            /// The flow in use.
            fn flow(&) -> Flow;
            /// Time, s.
            fn time(&) -> f64;
            /// Runs to `time`.
            fn run_until(&mut, time: f64) -> Result<(), SimulationError>;
            /// Takes whole steps until `time` is reached or passed, none of them beyond `latest`.
            fn run_past(&mut, time: f64, latest: f64) -> Result<(), SimulationError>;
            /// Computes the state at an instant of the last step, passes it to the callback, and restores
            /// the state.
            fn look_at(&mut, time: f64, look: &mut dyn FnMut(&dyn AnySimulation)) -> Result<(), SimulationError>;
            /// Runs to a sign change of `event`.
            fn run_to_event(&mut, event: &str, latest: f64) -> Result<Option<f64>, SimulationError>;
            /// One step.
            fn step(&mut) -> Result<(), SimulationError>;
            /// The value of an `Input`.
            fn input(&, name: &str) -> Result<f64, UnknownName>;
            /// Sets an `Input`.
            fn set_input(&mut, name: &str, value: f64) -> Result<(), SimulationError>;
            /// The values of all `Input`s, in the order of [`Model::inputs`](crate::Model::inputs).
            fn input_values(&) -> Vec<f64>;
            /// Sets all `Input`s, in the order of [`Model::inputs`](crate::Model::inputs), or none.
            fn set_input_values(&mut, values: &[f64]) -> Result<(), SimulationError>;
            /// The value of a `State`.
            fn state_value(&, name: &str) -> Result<f64, UnknownName>;
            /// Sets a `State`.
            fn set_state_value(&mut, name: &str, value: f64) -> Result<(), SimulationError>;
            /// The value of an `Output`.
            fn output(&, name: &str) -> Result<f64, UnknownName>;
            /// All `Output`s.
            fn output_values(&) -> Vec<f64>;
            /// A generalized coordinate.
            fn coordinate(&, name: &str) -> Result<f64, UnknownName>;
            /// A generalized velocity.
            fn velocity(&, name: &str) -> Result<f64, UnknownName>;
            /// A named point, m.
            fn point(&, name: &str) -> Result<[f64; 3], UnknownName>;
            /// Named points, m.
            fn points(&) -> Vec<[f64; 3]>;
            /// The energy balance.
            fn energy(&) -> Energy;
            /// Joint reactions.
            fn reactions(&) -> Result<Reactions, SimulationError>;
            /// One component of a joint's reaction.
            fn reaction(&, joint: &str, component: &str) -> Result<f64, SimulationError>;
            /// The current instant as a row of results.
            fn sample(&) -> Sample;
            /// Work done and errors met so far.
            fn report(&) -> Report;
            /// The singular poses passed so far.
            fn rank_losses(&) -> &[RankLoss];
            /// The changes of the method so far.
            fn method_changes(&) -> &[MethodChange];
            /// The result of assembly.
            fn assembly(&) -> &AssemblyVerdict;
        }
    };
}
pub(crate) use methods_of_any_simulation;

macro_rules! declare {
    ($($(#[doc = $doc:literal])* fn $name:ident(&$($mutable:ident)? $(, $argument:ident: $kind:ty)*) -> $result:ty;)*) => {
        /// The object-safe form of [`Simulation`](crate::Simulation); each method is described there.
        pub trait AnySimulation: std::fmt::Debug {
            $($(#[doc = $doc])* fn $name(&$($mutable)? self $(, $argument: $kind)*) -> $result;)*
            /// q.
            fn coordinates(&self) -> Vec<f64>;
            /// v.
            fn velocities(&self) -> Vec<f64>;
        }
    };
}

methods_of_any_simulation!(declare);
