//! All tests of the runtime in one program: it links once, and its tests share the processors.

mod common;

mod access;
mod accuracy;
mod at_rest;
mod baselines;
mod clean;
mod clock;
mod composition;
mod contract;
mod copies;
mod dense_mass;
mod driven_steps;
mod dynamics;
mod energy_gain;
mod ensemble;
mod equilibrium;
mod extrapolation;
mod fixed_steps;
mod flows;
mod holonomic;
mod hostile_settings;
mod jumps;
mod known_cost;
mod known_poses;
mod looks;
mod methods;
mod names;
mod near_singular;
mod other_assemblies;
mod other_values;
mod paper;
mod radau;
mod rank_losses;
mod redundant_short_steps;
mod references;
mod refused_changes;
mod round_off;
mod scales;
mod scissor_lift;
mod short_pieces;
mod small_implicit_steps;
mod spatial;
mod tolerance;
mod ui;
mod vanishing_rows;

#[global_allocator]
static ALLOCATOR: common::alloc::Counting = common::alloc::Counting;
