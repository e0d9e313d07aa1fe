//! The four-bar with ten loops (LIM A02, N = 10), between those with two and forty loops, to show the growth of the
//! cost of a step. It is singular when all bars are horizontal: the rank is lower by ten.

use crate::scene::Scene;
use mbs_runtime::{Mechanism, mechanism};

mechanism!(FourBar10 {
    doc: "Ten parallelogram loops in a row.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each bar.
    length: Param(1.0_m),
    /// Mass of each bar.
    mass: Param(1.0_kg),
    /// Initial angular velocity of the cranks.
    turning: Param(-1.0_rad_per_s),

    crank: Each(0..=10, |i| Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    )),
    coupler: Each(1..=10, |i| Bar(mass = mass, length = length)),

    bearing: Each(0..=10, |i| Revolute(
        ground.point(i * length, 0.0),
        crank[i].a
    )),
    left: Each(1..=10, |i| Revolute(crank[i - 1].b, coupler[i].a)),
    right: Each(1..=10, |i| Revolute(crank[i].b, coupler[i].b)),

    b0: Output(crank[0].b),
    b0_velocity: Output(crank[0].b.velocity),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "four-bar-10",
    title: "Ten four-bar loops in a row",
    source: "LIM benchmark A02, N = 10",
    model: FourBar10::MODEL,
    duration: 20.0,
    step: 1e-2,
    reference: None,
    build: crate::build_scene!(FourBar10),
};
