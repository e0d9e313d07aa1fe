//! The double four-bar (IFToMM A02 with N = 2): three cranks, two couplers, all of 1 m and 1 kg. When all bars are
//! horizontal the rank of the constraint Jacobian is lower by two, and the motion could continue on another branch than
//! the parallelogram branch. Reference: closed form of the parallelogram branch.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(DoubleFourBar {
    doc: "Three cranks and two couplers in a row: five bars, one degree of freedom, singular when horizontal.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each bar.
    length: Param(1.0_m),
    /// Mass of each bar.
    mass: Param(1.0_kg),
    /// Initial angular velocity of the cranks.
    turning: Param(-1.0_rad_per_s),

    a1: Point([length, 0.0_m]),
    a2: Point([2.0 * length, 0.0_m]),

    crank0: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank1: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank2: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    coupler1: Bar(mass = mass, length = length),
    coupler2: Bar(mass = mass, length = length),

    bearing0: Revolute(ground.origin, crank0.a),
    bearing1: Revolute(a1, crank1.a),
    bearing2: Revolute(a2, crank2.a),
    pin0: Revolute(crank0.b, coupler1.a),
    pin1: Revolute(crank1.b, coupler1.b),
    pin1b: Revolute(crank1.b, coupler2.a),
    pin2: Revolute(crank2.b, coupler2.b),

    b0: Output(crank0.b),
    b0_velocity: Output(crank0.b.velocity),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "double-four-bar",
    title: "Double four-bar, singular when horizontal",
    source: "IFToMM benchmark A02, N = 2; Potosakis, Paraskevopoulos, Natsiavas 2020, section 7.3",
    model: DoubleFourBar::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: Some(Reference {
        file: "a02_four_bar_n2.csv",
        columns: &[
            ("b0.x", "b0x_m"),
            ("b0.y", "b0y_m"),
            ("b0_velocity.x", "b0vx_m_per_s"),
            ("b0_velocity.y", "b0vy_m_per_s"),
        ],
    }),
    build: crate::build_scene!(DoubleFourBar),
};
