//! A skate on an inclined plane. On average it moves across the slope, not down, because the knife edge turns.
//!
//! Reference: closed form.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(KnifeEdge {
    doc: "A skate on an inclined plane; x points down the slope.",
    world: Planar(gravity = [9.81_m_per_s2 * incline.sin(), 0.0]),

    /// Inclination of the plane.
    incline: Param(30.0_deg),
    /// Mass.
    mass: Param(2.0_kg),
    /// Moment of inertia about the centre of mass, which is above the edge.
    inertia: Param(0.5_kg_m2),
    /// Initial heading.
    heading: Param(0.0_deg),
    /// Initial rate of turning.
    turning: Param(1.5_rad_per_s),
    /// Initial forward speed.
    speed: Param(0.0_m_per_s),

    skate: Body(
        mass = mass,
        inertia = inertia,
        at = [0.0_m, 0.0_m],
        velocity = [speed * heading.cos(), speed * heading.sin()],
        angle = heading,
        rate = turning,
    ),
    edge: Nonholonomic(dot(skate.velocity, skate.y)),

    position: Output(skate.origin),
    angle: Output(skate.angle),
    forward: Output(dot(skate.velocity, skate.x)),
});

impl KnifeEdge {
    /// A start with some speed across the slope.
    pub fn moving_start() -> Self {
        KnifeEdge {
            heading: 0.4,
            turning: -0.8,
            speed: 1.1,
            ..KnifeEdge::default()
        }
    }
}

const SOURCE: &str = "Bahar 1998; Bloch: Nonholonomic Mechanics and Control";
const COLUMNS: &[(&str, &str)] = &[
    ("position.x", "x_m"),
    ("position.y", "y_m"),
    ("angle", "phi_rad"),
    ("forward", "forward_v_m_per_s"),
];

/// From rest.
pub const SCENE: Scene = Scene {
    name: "knife-edge",
    title: "Skate on an incline, from rest",
    source: SOURCE,
    model: KnifeEdge::MODEL,
    duration: 10.0,
    step: 1e-2,
    reference: Some(Reference {
        file: "knife_edge_incline.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(KnifeEdge),
};

/// With a start across the slope.
pub const MOVING: Scene = Scene {
    name: "knife-edge-moving",
    title: "Skate on an incline, with a start across the slope",
    source: SOURCE,
    model: KnifeEdge::MODEL,
    duration: 10.0,
    step: 1e-2,
    reference: Some(Reference {
        file: "knife_edge_incline_moving_start.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(KnifeEdge, KnifeEdge::moving_start()),
};
