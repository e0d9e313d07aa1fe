//! A disk that rolls without slip on a plane: one holonomic and two nonholonomic rows. Two starts: upright and fast
//! enough for a steady motion, and a coin that is almost flat and wobbles.
//!
//! The energy error is of second order and does not grow: the kicks of gravity and of the contact act at the ends of a
//! step, between which the height changes. (1.5e-6 J with steps of 1 ms, 3.7e-7 J with half of that.)
//!
//! Reference: quasi-velocity equations, integrated with high precision.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(RollingDisk {
    doc: "A thin disk rolling on the plane z = 0.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    /// Mass.
    mass: Param(2.5_kg),
    /// Radius.
    radius: Param(0.4_m),
    /// Lean from the vertical at the start.
    lean: Param(0.2_rad),
    /// Rate of turning about the vertical at the start.
    turning: Param(1.2_rad_per_s),
    /// Rate of rolling about the disk's axis at the start.
    rolling: Param(-5.0_rad_per_s),

    upward: Let([0.0, -sin(lean), cos(lean)]),
    omega: Let([0.0, rolling * cos(lean), turning + rolling * sin(lean)]),

    disk: Body(
        mass = mass,
        inertia = diag(0.25, 0.5, 0.25) * mass * radius.powi(2),
        at = [0.0, 0.0, radius * cos(lean)],
        orientation = turn(X, lean),
        velocity = cross(omega, radius * upward),
        angular_velocity = omega,
        shape = Cylinder(radius, 0.02 * radius, Y),
    ),

    down: Let(-unit(reject(ground.z, disk.y))),
    contact: Let(disk.origin + radius * down),
    slip: Let(disk.velocity_at(contact)),

    touch: Holonomic(dot(contact, ground.z)),
    no_slip: Nonholonomic([dot(slip, ground.x), dot(slip, ground.y)]),

    center: Output(disk.origin),
    contact_x: Output(contact.x),
    contact_y: Output(contact.y),
});

const COLUMNS: &[(&str, &str)] = &[
    ("center.x", "cx_m"),
    ("center.y", "cy_m"),
    ("center.z", "cz_m"),
    ("contact_x", "contact_x_m"),
    ("contact_y", "contact_y_m"),
];

/// The steady start.
pub const SCENE: Scene = Scene {
    name: "rolling-disk",
    title: "Rolling disk",
    source: "Neimark, Fufaev: Dynamics of Nonholonomic Systems",
    model: RollingDisk::MODEL,
    duration: 10.0,
    step: 5e-4,
    reference: Some(Reference {
        file: "rolling_disk.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(RollingDisk),
};

/// The coin.
pub const TILTED: Scene = Scene {
    name: "rolling-disk-tilted",
    title: "Rolling coin, almost flat",
    duration: 2.0,
    step: 5e-5,
    reference: Some(Reference {
        file: "rolling_disk_tilted.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(
        RollingDisk,
        RollingDisk {
            mass: 0.4,
            radius: 0.0375,
            lean: 1.2,
            turning: 18.0,
            rolling: -14.0,
        }
    ),
    ..SCENE
};
