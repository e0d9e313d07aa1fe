//! Loops of joints in space by the angles of their joints: processor time for an evaluation of the accelerations, with its
//! share of the rest of an explicit step of order 8, and for a step of the two-level method.
//!
//! `cargo run --release -p mbs-parts --features large --example loops`

use mbs_runtime::{SimulationError, assembly, mechanism};

#[path = "run/timing.rs"]
mod timing;
use timing::line;

assembly!(Arms {
    doc: "Three arms on the ground and the plate that they carry.",
    world: Spatial(),
    /// Directions of the arms.
    x: Each(0..3, |i| Let(cos(i * 120.0_deg))),
    y: Each(0..3, |i| Let(sin(i * 120.0_deg))),
    plate: Body(
        mass = 0.3_kg,
        inertia = diag(1e-3_kg_m2, 1e-3_kg_m2, 2e-3_kg_m2),
        at = [0.0, 0.0, -0.5]
    ),
    arm: Each(0..3, |i| Bar(
        mass = 0.4_kg,
        from = [0.2_m * x[i], 0.2_m * y[i], 0.0_m],
        to = [0.4_m * x[i], 0.4_m * y[i], -0.05_m],
        radius = 0.01_m
    )),
    hip: Each(0..3, |i| Revolute(
        ground,
        arm[i],
        at = arm[i].a,
        axis = [-y[i], x[i], 0.0]
    )),
    tool: Output(plate.origin),
});

mechanism!(Delta {
    doc: "A delta robot: three arms, each with two rods, that carry a plate.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    arms: Assembly(Arms),
    // Two rods, 0.04 m to each side of their arm.
    aside: Each((0..2, 0..3), |k, i| Let([
        0.04_m * (1 - 2 * k) * arms.y[i],
        0.04_m * (2 * k - 1) * arms.x[i],
        0.0_m
    ])),
    rod: Each((0..2, 0..3), |k, i| Bar(
        mass = 0.1_kg,
        from = arms.arm[i].b + aside[k][i],
        to = arms.plate.origin + 0.05_m * [arms.x[i], arms.y[i], 0.0] + aside[k][i],
        radius = 0.005_m
    )),
    upper: Each((0..2, 0..3), |k, i| Spherical(
        arms.arm[i],
        rod[k][i],
        at = rod[k][i].a
    )),
    lower: Each((0..2, 0..3), |k, i| Universal(
        rod[k][i],
        arms.plate,
        at = rod[k][i].b,
        axis = [-arms.y[i], arms.x[i], 0.0],
        second_axis = [arms.x[i], arms.y[i], 0.0]
    )),
});

mechanism!(DeltaOfRods {
    doc: "The same with rods that are lengths between points.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    arms: Assembly(Arms),
    aside: Each(0..2, |k| Let(0.04_m * (2 * k - 1))),
    elbow: Each((0..2, 0..3), |k, i| Let(
        arms.arm[i].point(0.103_m, aside[k], 0.0_m)
    )),
    wrist: Each((0..2, 0..3), |k, i| Let(arms.plate.point(
        0.05_m * arms.x[i] - aside[k] * arms.y[i],
        0.05_m * arms.y[i] + aside[k] * arms.x[i],
        0.0_m
    ))),
    rod: Each((0..2, 0..3), |k, i| Distance(
        elbow[k][i],
        wrist[k][i],
        length = norm(wrist[k][i] - elbow[k][i])
    )),
});

mechanism!(Ring {
    doc: "A ring of twelve rods that hangs from one of its joints.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    corner: Each(0..=12, |i| Let([
        1.0_m * cos(i * 30.0_deg),
        0.0_m,
        1.0_m * sin(i * 30.0_deg)
    ])),
    rod: Each(0..12, |i| Bar(
        mass = 0.1_kg,
        from = corner[i],
        to = corner[i + 1],
        radius = 0.01_m
    )),
    hook: Spherical(ground, rod[3], at = rod[3].a),
    joint: Each(1..12, |i| Universal(
        rod[i - 1],
        rod[i],
        at = rod[i].a,
        axis = Y,
        second_axis = cross(Y, unit(rod[i].b - rod[i].a))
    )),
    clasp: Spherical(rod[11], rod[0], at = rod[0].a),
    low: Output(rod[9].a),
});

fn main() -> Result<(), SimulationError> {
    timing::heading();
    line::<DeltaOfRods, _, _, _, _>()?;
    line::<Delta, _, _, _, _>()?;
    line::<Ring, _, _, _, _>()
}
