//! The rattleback: half an ellipsoid whose principal axes of inertia are not parallel to those of its surface. If it
//! spins in the wrong direction, it begins to rattle, stops, and then spins in the other direction; no work is done on
//! it, and its energy is constant.

use crate::scene::Scene;
use mbs_runtime::{Mechanism, mechanism};

mechanism!(Rattleback {
    doc: "An ellipsoid that rolls without slip, with skewed axes of inertia.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    /// Mass.
    mass: Param(1.0_kg),
    /// Semi-axes of the surface.
    length: Param(0.2_m),
    width: Param(0.03_m),
    height: Param(0.02_m),
    /// Depth of the centre of mass below the centre of the ellipsoid.
    depth: Param(0.005_m),
    /// Principal moments of inertia.
    roll_inertia: Param(2.0e-4_kg_m2),
    pitch_inertia: Param(1.6e-3_kg_m2),
    yaw_inertia: Param(1.7e-3_kg_m2),
    /// Angle between the axes of inertia and those of the surface.
    skew: Param(2.0_deg),
    /// Spin at the start.
    spin: Param(-5.0_rad_per_s),
    /// Rate of pitching at the start.
    disturbance: Param(0.02_rad_per_s),

    mean: Let(0.5 * (roll_inertia + pitch_inertia)),
    half: Let(0.5 * (roll_inertia - pitch_inertia)),

    stone: Body(
        mass = mass,
        inertia = [
            [mean + half * cos(2.0 * skew), half * sin(2.0 * skew), 0.0],
            [half * sin(2.0 * skew), mean - half * cos(2.0 * skew), 0.0],
            [0.0, 0.0, yaw_inertia],
        ],
        center_of_mass = [0.0, 0.0, -depth],
        at = [0.0, 0.0, height],
        velocity = cross([0.0, disturbance, spin], [0.0, 0.0, height]),
        angular_velocity = [0.0, disturbance, spin],
        shape = Cuboid(1.6 * length, 1.4 * width, height),
    ),

    // the lowest point of the ellipsoid, along its own axes
    nx: Let(length * dot(stone.x, ground.z)),
    ny: Let(width * dot(stone.y, ground.z)),
    nz: Let(height * dot(stone.z, ground.z)),
    reach: Let(sqrt(nx * nx + ny * ny + nz * nz)),
    contact: Let(stone.origin
        - (length * nx / reach) * stone.x
        - (width * ny / reach) * stone.y
        - (height * nz / reach) * stone.z),
    slip: Let(stone.velocity_at(contact)),

    touch: Holonomic(stone.origin.z - reach),
    no_slip: Nonholonomic([dot(slip, ground.x), dot(slip, ground.y)]),

    spin_rate: Output(dot(stone.angular_velocity, ground.z)),
    contact_x: Output(contact.x),
    contact_y: Output(contact.y),
    pitch: Output(asin(dot(stone.x, ground.z))),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "rattleback",
    title: "Rattleback",
    source: "Garcia, Hubbard 1988: Spin reversal of the rattleback",
    model: Rattleback::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(Rattleback),
};
