//! The compiler behind `mechanism!`: declaration → derived equations → Rust, in six stages.
//!
//! ```text
//!  tokens ─1 syntax─▶ tree ─2 model─▶ Model ─3 equations─▶ System ─4 derivatives─▶ Derived ─5 dag─▶ Program ─6 emit─▶ Rust
//! ```
//!
//! Errors of users occur in stages 1 and 2; they are collected within a stage and stop the compiler between stages. What only
//! the equations show is refused after them: `deny: Redundant()`, reactions that are not there, and the `budget`.
//! Stages 3 to 5 have no tokens, and nothing outside stage 6 writes Rust.

pub mod analysis;
mod assemblies;
mod budget;
mod choose;
pub mod compile;
pub mod contract;
pub mod diagnostics;
pub mod dimension;
pub mod explain;
mod home;
pub mod mobility;
pub mod names;
pub mod reference;
mod refusals;
pub mod schema;
pub mod symbolic;

// The stages, in order.
pub mod dag;
pub mod derivatives;
pub mod emit;
pub mod equations;
pub mod model;
pub mod syntax;

pub use analysis::{Analysis, Candidate};
pub use compile::{analyse, compile, compile_assembly};
