//! Tests of declarations and of what follows from them: messages, equations, emitted Rust, metadata, documents.
//!
//! Runs are in `motion.rs`: two programs, which the compiler builds at the same time.

mod common;

mod advice;
mod assemblies;
mod book;
mod changing_parameters;
mod data;
mod depth;
mod derivatives;
mod descriptions;
mod editor;
mod elimination;
mod entries;
mod families;
mod flipped_signs;
mod force_axes;
mod formulations;
mod fuzz;
mod held_starts;
mod home;
mod home_places;
mod integrability;
mod large;
mod layers;
mod left_out;
mod loads;
mod massless;
mod mobility;
mod new_joint;
mod newton_euler;
mod packages;
mod parameter_checks;
mod parts;
mod reactions;
mod recordings;
mod reference_page;
mod rustfmt;
mod silent;
mod simplification;
mod sizes;
mod snapshots;
mod spans;
mod starts;
mod tables;
mod ui;
mod units;
