//! Multibody mechanisms declared in Rust, simulated with ALF-3F.

// Comparisons are negated on purpose, so that a NaN fails the test.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

pub mod alf3f;
mod any;
mod assembly;
mod energy;
mod error;
mod flow;
#[doc(hidden)]
pub mod generated;
mod integrator;
mod linear;
mod mechanism;
mod model;
pub mod output;
mod reactions;
mod report;
mod samples;
mod settings;
mod simulation;
mod simulation_error;
mod sink;
mod state;

pub use alf3f::{PaperStepper, TwoLevelStepper};
pub use any::AnySimulation;
pub use error::{ParameterError, UnknownName};
pub use mbs_macros::mechanism;
pub use mechanism::{Mechanism, System};
pub use model::{
    Coordinate, FunctionCost, Model, Part, Quantity, Reaction, Row, RowKind, Segment, Structure,
};
pub use report::{AssemblyVerdict, Energy, Reactions, Report, Sample};
pub use samples::Samples;
pub use settings::{Flow, Method, PaperSettings, Settings};
pub use simulation::Simulation;
pub use simulation_error::SimulationError;
pub use sink::{MatrixSink, TensorSink};
pub use state::{Ledger, State, ThreeFields};
