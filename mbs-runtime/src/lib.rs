//! Multibody mechanisms declared in Rust, simulated with ALF-3F.
//!
//! A mechanism with generalized coordinates q, velocities v (q̇ = v but for rotations), mass matrix M and constraint rows φ obeys
//!
//! ```text
//! d(M v)/dt − ∂T/∂q = f(q, v, t) + Aᵀλ        φ(q, t) = 0,  A v + b = 0,  A = ∂φ/∂q,  b = ∂φ/∂t
//! ```
//!
//! with further rows N(q) v + n(q, t) = 0 where it is nonholonomic. [`mechanism!`] derives all of it symbolically from a
//! declaration, at compile time, and writes it as Rust; [`Simulation`] assembles and integrates it.
//!
//! ```
//! use mbs_runtime::{Mechanism, Simulation, mechanism};
//!
//! mechanism!(Pendulum {
//!     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
//!     length: Param(1.0_m),
//!     rod: Bar(mass = 1.0_kg, length = length, angle = 0.0_deg),
//!     pivot: Revolute(ground.origin, rod.a),
//!     height: Output(rod.b.y),
//! });
//!
//! # fn main() -> Result<(), Box<dyn core::error::Error>> {
//! let mut simulation = Simulation::new(Pendulum { length: 0.5 })?;
//! simulation.run_until(1.0)?;
//! assert!(simulation.outputs().height < 0.0);
//! assert!(simulation.energy().error.abs() < 1e-4);
//! assert_eq!(Pendulum::MODEL.velocities.len(), 1);
//! # Ok(())
//! # }
//! ```
//!
//! # The integrators
//!
//! | method | what it is |
//! |---|---|
//! | [`Method::TwoLevel`] | the three fields of ALF-3F with separate multipliers for positions and for velocities: kick, flow, kick; second order, symmetric, composed to order 4, 6 or 8, or extrapolated where forces depend on velocities ([`Settings::order`]); position rows are solved for and velocity rows projected onto at every step; redundant rows and singular poses are ordinary input |
//! | [`Method::Paper`] | Algorithm 1 of Potosakis, Paraskevopoulos, Natsiavas (Nonlinear Dynamics, 2020), to the letter |
//! | [`Method::MAlf`] | the modified augmented Lagrangian that their paper compares with |
//! | [`Method::Projected`] | explicit Runge–Kutta of order 4, 6 or 8 on the equations at acceleration level, positions and velocities projected onto the rows after each step |
//! | [`Method::Baumgarte`] | the same with Baumgarte's terms instead, with given steps or with error control |
//! | [`Method::Rattle`] | RATTLE, without regularisation |
//! | [`Method::Index3Projections`] | augmented Lagrangian of index 3 with projections of velocities and accelerations |
//! | [`Method::GeneralizedAlpha`] | the generalized-α method of index 3, or of the stabilised index 2 |
//! | [`Method::Bdf`] | backward differentiation of index 3, of variable order and step |
//! | [`Method::Radau`] | Radau IIA of order 5 with the rows of velocities at its stages, positions and velocities projected onto the rows after each step: stiff forces of velocity |
//! | [`Method::Penalty`] | rows as stiff springs and dampers |
//!
//! All except two-level, projected and Radau are methods of the literature for comparison, on the same generated equations and
//! with the same diagnostics. A method is compiled for a mechanism only where a program names it ([`methods`]) for
//! [`Simulation::with_methods`], or asks for all: [`Simulation::with_any_method`], [`simulate_ensemble_with_any_method`].
//! [`Simulation::with_accuracy`] compiles those three. [`Simulation::new`] and [`Simulation::with_settings`] compile the
//! two-level method alone, and refuse the others.
//!
//! The two-level step chooses the flow between its kicks from the structure of the equations ([`Structure`]):
//!
//! | M | forces depend on | flow |
//! |---|---|---|
//! | constant | positions | [`Flow::Leapfrog`], explicit (or the trapezoid, where a spring is stiff for the step) |
//! | depends on q | positions | [`Flow::Midpoint`], implicit, in momentum form |
//! | any | velocities | [`Flow::Implicit`], with the multiplier inside the step |
//!
//! # Features
//!
//! * `sparse`: large mechanisms of every structure without dense arrays.
//! * `plot`: diagrams of recorded runs as SVG ([`output::Recording::save`]).
//! * `latex`: `Model::latex`, the equations of motion; adds the compiler of `mechanism!` to the program.
//! * `serde`: [`State`], [`Settings`], [`Sample`], [`Report`], [`Reactions`] and [`output::Frame`] can be written and
//!   read by `serde`, [`AssemblyVerdict`] written. Settings that are read may leave fields out; a field that does not exist
//!   is an error. Numbers of samples, reactions and frames that are not known are NaN, and `null` in JSON; `null` is read as NaN.
//!   A state that is read with all digits goes on bit for bit.
//!
//! # Without the standard library
//!
//! Without its feature `std`, which is on by default, the crate is `no_std` and allocates nothing: it has mechanisms,
//! [`Dynamics`], [`TwoLevelStepper`] and [`FixedStepSimulation`].

// Comparisons are negated on purpose, so that a NaN fails the test.
#![allow(clippy::neg_cmp_op_on_partial_ord)]
#![cfg_attr(not(feature = "std"), no_std)]
// Without `std` some items have no user left: those that `Simulation` alone uses.
#![cfg_attr(not(feature = "std"), allow(dead_code, unused_imports))]

mod acceleration_level;
mod affinities;
mod alf3f;
#[cfg(feature = "std")]
mod any;
mod assembly;
#[cfg(feature = "std")]
mod baselines;
#[cfg(feature = "std")]
pub mod c_interface;
mod check;
mod constraint_geometry;
mod contract;
mod dynamics;
mod elementary;
mod energy;
#[cfg(feature = "std")]
mod ensemble;
mod error;
mod estimate;
mod fault;
mod fixed_step_simulation;
mod flow;
mod free;
#[doc(hidden)]
pub mod generated;
#[cfg(not(feature = "std"))]
mod hosted;
#[cfg(feature = "std")]
mod integrator;
mod known_cost;
mod large;
mod linear;
mod mechanism;
mod memory;
#[cfg(feature = "std")]
pub mod methods;
mod model;
#[cfg(feature = "std")]
pub mod output;
#[cfg(feature = "std")]
mod reactions;
#[cfg(feature = "serde")]
mod read_numbers;
mod report;
mod row_scale;
#[cfg(feature = "std")]
mod samples;
mod scalar_state;
mod settings;
#[cfg(feature = "std")]
mod simulation;
mod simulation_error;
mod singular;
mod sink;
mod state;
#[cfg(feature = "std")]
mod stepper;
mod work;
mod yardstick;

pub use alf3f::TwoLevelStepper;
pub use contract::{Configuration, Constraints, Inertia, Loads, NamedValues, Observables, System};
pub use dynamics::Dynamics;
pub use error::{ParameterError, UnknownName};
pub use fixed_step_simulation::FixedStepSimulation;
#[cfg(not(feature = "std"))]
#[doc(hidden)]
pub use hosted::Simulation;
pub use mbs_macros::{assembly, mechanism};
pub use mechanism::Mechanism;
pub use model::{
    Candidate, Coordinate, FunctionCost, Held, Level, Mobility, Model, Part, Quantity, Reaction,
    Redundancy, Row, RowKind, ScalarState, Segment, Structure, World,
};
pub use nalgebra;
pub use report::{Energy, MethodChange, RankLoss, Report};
pub use settings::{
    BaumgarteSettings, BdfSettings, Flow, GeneralizedAlphaSettings, Method, MultiplierStart,
    PaperSettings, PenaltySettings, ProjectionSettings, RowDirection, Settings,
};
pub use simulation_error::{ErrorOf, SimulationError};
pub use sink::{MatrixSink, TensorSink};
#[cfg(feature = "std")]
pub use state::KnownPoses;
#[cfg(feature = "sparse")]
pub use state::{BackwardDifferences, FactorOrigin, Renewal};
pub use state::{
    EnergyRange, Foreseen, LastStep, Ledger, PosesAhead, State, StepController, ThreeFields,
};
#[cfg(feature = "std")]
pub use {
    alf3f::PaperStepper,
    any::AnySimulation,
    baselines::BaselineStepper,
    ensemble::{simulate_ensemble, simulate_ensemble_with_any_method},
    report::{AssemblyVerdict, Change, HeldGap, OpenRow, Reactions, Sample},
    samples::Samples,
    simulation::{InputsMut, Simulation, Start},
};
