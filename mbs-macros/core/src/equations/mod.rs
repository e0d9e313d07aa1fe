//! Stage 3: model → system.
//!
//! AFTER THIS STAGE: M, V, applied forces, rows, reactions and outputs are expressions in the generalized coordinates q,
//! velocities v, time, parameters and inputs, and the initial guesses are final. There are no parts, points or tokens any
//! more.

mod balance;
mod carried_start;
mod constant_mass;
mod derive;
mod forces;
mod generalized_forces;
mod inertia;
mod inverse_mass;
mod kinetic;
mod reactions;
mod readings;
mod rows;
mod start;
mod states;
mod system;
mod vacuous;

pub use derive::derive;
pub use generalized_forces::ForceParts;
pub use inverse_mass::InverseMass;
pub use kinetic::Kinetic;
pub use readings::UnknownReading;
pub use system::{Reaction, Row, RowKind, System, VacuousRow};
