//! Tests of runs: references, singular poses, stops, drives, steps for a tolerance, allocations.

#[path = "../../mbs-runtime/tests/common/alloc.rs"]
mod alloc;
#[allow(dead_code)]
#[path = "../../mbs-examples/examples/compile_times/declarations.rs"]
mod sizes;

mod acceleration_outputs;
mod allocations;
mod baselines;
mod bushings;
mod damped_poses;
mod driven_poses;
mod driven_works;
mod drives;
mod folding;
mod followers;
mod friction;
mod held_angles;
mod independent_velocities;
mod joint_angles;
mod long_family;
mod marks;
mod measured_tables;
mod method_changes;
mod passages;
mod planar_joints;
mod planar_places;
mod planar_starts;
mod planned_accelerations;
mod planned_poses;
mod poses;
mod references;
mod rest;
mod robust;
mod rolling;
mod scopes;
mod slopes;
mod solved_rows;
mod space_starts;
mod spatial_scenes;
mod special_values;
mod starts_in_poses;
mod states;
mod stops;
mod tolerances;
mod tree_joints;
mod turning;
mod undetermined;

#[global_allocator]
static ALLOCATOR: alloc::Counting = alloc::Counting;
