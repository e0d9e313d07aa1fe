//! The planar pendulum (IFToMM A01): a point mass on a massless bar, released from the horizontal. In one
//! scene it is a bar in a joint, of which the compiler takes the angle as coordinate; in the other this angle is declared.
//! Reference: closed form with elliptic functions.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(Pendulum {
    doc: "A point mass on a massless bar in a joint: the compiler takes the angle of the bar as coordinate.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of the bar.
    length: Param(1.0_m),
    /// The point mass.
    mass: Param(1.0_kg),

    bar: Bar(length = length, angle = 180.0_deg),
    bob: Particle(mass = mass),
    pivot: Revolute(ground.origin, bar.a),
    joint: Revolute(bar.b, bob.origin),

    x: Output(bob.origin.x),
    y: Output(bob.origin.y),
    vx: Output(bob.velocity.x),
    vy: Output(bob.velocity.y),
});

mechanism!(PendulumByAngle {
    doc: "The same pendulum with the angle of the bar as a declared coordinate.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of the bar.
    length: Param(1.0_m),
    /// The point mass.
    mass: Param(1.0_kg),

    /// Angle of the bar, from ground.x.
    theta: Coordinate(180.0_deg),
    bob: Particle(
        mass = mass,
        position = [length * theta.cos(), length * theta.sin()]
    ),

    x: Output(bob.origin.x),
    y: Output(bob.origin.y),
    vx: Output(bob.velocity.x),
    vy: Output(bob.velocity.y),
});

const SOURCE: &str =
    "IFToMM benchmark A01; Potosakis, Paraskevopoulos, Natsiavas 2020, section 7.1";
const REFERENCE: Option<Reference> = Some(Reference {
    file: "a01_pendulum_10s.csv",
    columns: &[
        ("x", "x_m"),
        ("y", "y_m"),
        ("vx", "vx_m_per_s"),
        ("vy", "vy_m_per_s"),
    ],
});

/// As a bar.
pub const SCENE: Scene = Scene {
    name: "pendulum",
    title: "Planar pendulum, as a bar",
    source: SOURCE,
    model: Pendulum::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: REFERENCE,
    build: crate::build_scene!(Pendulum),
};

/// By its angle.
pub const BY_ANGLE: Scene = Scene {
    name: "pendulum-angle",
    title: "Planar pendulum, by its angle",
    source: SOURCE,
    model: PendulumByAngle::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: REFERENCE,
    build: crate::build_scene!(PendulumByAngle),
};
