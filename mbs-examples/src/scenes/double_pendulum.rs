//! Two uniform bars in a row: the simplest mechanism with a chaotic motion. It is checked by its energy.

use crate::scene::Scene;
use mbs_runtime::{Mechanism, mechanism};

mechanism!(DoublePendulum {
    doc: "Two uniform bars in a row, released from the horizontal.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each bar.
    length: Param(1.0_m),
    /// Mass of each bar.
    mass: Param(1.0_kg),

    upper: Bar(mass = mass, length = length, angle = 0.0_deg),
    lower: Bar(mass = mass, length = length, angle = 0.0_deg),
    pivot: Revolute(ground.origin, upper.a),
    elbow: Revolute(upper.b, lower.a),

    elbow_point: Output(upper.b),
    tip: Output(lower.b),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "double-pendulum",
    title: "Double pendulum",
    source: "textbook; checked by its energy",
    model: DoublePendulum::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(DoublePendulum),
};
