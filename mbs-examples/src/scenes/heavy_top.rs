//! The heavy top: a disk of 15 kg at the end of a rod of 1 m that is held by a ball joint, spinning at 150 rad/s.
//!
//! Reference: quaternion and angular velocity, integrated with high precision.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(HeavyTop {
    doc: "A spinning top with a fixed point: a body and a ball joint.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    /// Mass.
    mass: Param(15.0_kg),
    /// Moment of inertia about the axis of symmetry.
    axial: Param(0.46875_kg_m2),
    /// Moment of inertia across it, about the centre of mass.
    transverse: Param(0.234375_kg_m2),
    /// Distance of the centre of mass from the pivot.
    height: Param(1.0_m),
    /// Spin about the axis.
    spin: Param(150.0_rad_per_s),
    /// Precession at the start.
    precession: Param(-4.61538_rad_per_s),

    top: Body(
        mass = mass,
        inertia = diag(transverse, axial, transverse),
        center_of_mass = [0.0, height, 0.0],
        angular_velocity = [0.0, spin, precession],
        shape = Cylinder(0.25 * height, 0.05 * height, Y),
    ),
    pivot: Spherical(ground.origin, top.origin),

    center: Output(top.center),
    momentum_z: Output(
        mass * cross(top.center, top.center.velocity).z
            + dot(axial * dot(top.angular_velocity, top.y) * top.y, ground.z)
            + dot(transverse * reject(top.angular_velocity, top.y), ground.z)
    ),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "heavy-top",
    title: "Heavy top",
    source: "Géradin, Cardona 2001; Brüls, Cardona 2010",
    model: HeavyTop::MODEL,
    duration: 2.0,
    step: 2e-4,
    reference: Some(Reference {
        file: "heavy_top.csv",
        columns: &[
            ("center.x", "x_m"),
            ("center.y", "y_m"),
            ("center.z", "z_m"),
            ("momentum_z", "angular_momentum_z_kgm2_per_s"),
        ],
    }),
    build: crate::build_scene!(HeavyTop),
};
