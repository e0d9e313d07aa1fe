//! A spherical pendulum: a point on a massless rod, three coordinates and one row. The angular momentum about the
//! vertical and the energy are constant, and the height oscillates between two roots of a cubic.

use crate::scene::Scene;
use mbs_runtime::{Mechanism, mechanism};

mechanism!(SphericalPendulum {
    doc: "A point mass on a massless rod that hangs from a ball joint.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    /// Length of the rod.
    length: Param(1.0_m),
    /// Mass of the bob.
    mass: Param(2.0_kg),
    /// Speed at the start, horizontal, where the rod is horizontal.
    speed: Param(2.0_m_per_s),

    rod: Bar(from = [0.0_m, 0.0, 0.0], to = [length, 0.0, 0.0]),
    bob: Particle(
        mass = mass,
        at = [length, 0.0, 0.0],
        velocity = [0.0, speed, 0.0]
    ),
    pivot: Spherical(ground.origin, rod.a),
    knot: Spherical(rod.b, bob),

    bob_position: Output(bob.origin),
    momentum_z: Output(mass * cross(bob.origin, bob.velocity).z),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "spherical-pendulum",
    title: "Spherical pendulum",
    source: "closed form in elliptic functions; Whittaker: Analytical Dynamics, § 55",
    model: SphericalPendulum::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(SphericalPendulum),
};
