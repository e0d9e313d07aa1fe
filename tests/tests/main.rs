//! All tests of this package in one program: it links once, and its tests share the processors.

#[path = "../../mbs-runtime/tests/common/alloc.rs"]
mod alloc;
mod common;
#[allow(dead_code)]
#[path = "../../mbs-examples/examples/compile_times/declarations.rs"]
mod sizes;

mod acceleration_outputs;
mod allocations;
mod assemblies;
mod baselines;
mod book;
mod changing_parameters;
mod damped_poses;
mod data;
mod derivatives;
mod descriptions;
mod driven_poses;
mod drives;
mod editor;
mod elimination;
mod families;
mod flipped_signs;
mod folding;
mod force_axes;
mod formulations;
mod friction;
mod fuzz;
mod held_starts;
mod home;
mod independent_velocities;
mod integrability;
mod large;
mod layers;
mod left_out;
mod long_family;
mod marks;
mod measured_tables;
mod mobility;
mod new_joint;
mod newton_euler;
mod packages;
mod parameter_checks;
mod parts;
mod passages;
mod planar_joints;
mod planar_places;
mod planned_accelerations;
mod planned_poses;
mod poses;
mod reactions;
mod recordings;
mod reference_page;
mod references;
mod rest;
mod robust;
mod rolling;
mod rustfmt;
mod scopes;
mod simplification;
mod slopes;
mod snapshots;
mod solved_rows;
mod spans;
mod spatial_scenes;
mod starts;
mod starts_in_poses;
mod states;
mod stops;
mod tables;
mod tolerances;
mod tree_joints;
mod ui;
mod undetermined;
mod units;

#[global_allocator]
static ALLOCATOR: alloc::Counting = alloc::Counting;
