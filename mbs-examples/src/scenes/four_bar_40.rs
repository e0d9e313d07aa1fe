//! The four-bar with 40 loops (LIM A02, N = 40): 41 cranks and 40 couplers, one degree of freedom. When all bars are
//! horizontal the rank is lower by 40. Reference: closed form of the parallelogram branch. Crank i is on the ground
//! at i metres, coupler i joins the tips of cranks i − 1 and i.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(FourBar40 {
    doc: "Forty parallelogram loops in a row.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each bar.
    length: Param(1.0_m),
    /// Mass of each bar.
    mass: Param(1.0_kg),
    /// Initial angular velocity of the cranks.
    turning: Param(-1.0_rad_per_s),

    crank: Each(0..=40, |i| Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    )),
    coupler: Each(1..=40, |i| Bar(mass = mass, length = length)),

    bearing: Each(0..=40, |i| Revolute(
        ground.point(i * length, 0.0),
        crank[i].a
    )),
    left: Each(1..=40, |i| Revolute(crank[i - 1].b, coupler[i].a)),
    right: Each(1..=40, |i| Revolute(crank[i].b, coupler[i].b)),

    b0: Output(crank[0].b),
    b0_velocity: Output(crank[0].b.velocity),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "four-bar-40",
    title: "Forty four-bar loops in a row",
    source: "LIM benchmark A02, N = 40",
    model: FourBar40::MODEL,
    duration: 20.0,
    step: 1e-2,
    reference: Some(Reference {
        file: "a02_four_bar_n40_lim.csv",
        columns: &[
            ("b0.x", "b0x_m"),
            ("b0.y", "b0y_m"),
            ("b0_velocity.x", "b0vx_m_per_s"),
            ("b0_velocity.y", "b0vy_m_per_s"),
        ],
    }),
    build: crate::build_scene!(FourBar40),
};
