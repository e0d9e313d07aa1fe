//! The Chaplygin sleigh: a body on a knife edge behind its centre of mass. It turns round, although no applied force
//! acts.
//!
//! Reference: closed form with hyperbolic functions.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(ChaplyginSleigh {
    doc: "A body on a knife edge, its centre of mass ahead of the edge: one nonholonomic row.",
    world: Planar(),

    /// Mass.
    mass: Param(3.0_kg),
    /// Moment of inertia about the centre of mass.
    inertia: Param(0.8_kg_m2),
    /// Distance of the centre of mass ahead of the edge.
    lead: Param(0.35_m),

    sleigh: Body(
        mass = mass,
        inertia = inertia,
        center_of_mass = [lead, 0.0],
        at = [0.0_m, 0.0_m],
        velocity = [-1.2_m_per_s, 0.0],
        angle = 0.0,
        rate = 0.6_rad_per_s,
    ),
    edge: Nonholonomic(dot(sleigh.velocity, sleigh.y)),

    edge_point: Output(sleigh.origin),
    angle: Output(sleigh.angle),
    omega: Output(sleigh.rate),
    forward: Output(dot(sleigh.velocity, sleigh.x)),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "chaplygin-sleigh",
    title: "Chaplygin sleigh",
    source: "Chaplygin 1911; Neimark, Fufaev: Dynamics of Nonholonomic Systems",
    model: ChaplyginSleigh::MODEL,
    duration: 10.0,
    step: 1e-2,
    reference: Some(Reference {
        file: "chaplygin_sleigh.csv",
        columns: &[
            ("edge_point.x", "edge_x_m"),
            ("edge_point.y", "edge_y_m"),
            ("angle", "theta_rad"),
            ("omega", "omega_rad_per_s"),
            ("forward", "forward_v_m_per_s"),
        ],
    }),
    build: crate::build_scene!(ChaplyginSleigh),
};
