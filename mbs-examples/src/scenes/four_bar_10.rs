//! The four-bar with ten loops (LIM A02, N = 10), between those with two and forty loops, to show the growth of the
//! cost of a step. It is singular when all bars are horizontal: the rank is lower by ten.

use crate::scene::Scene;
use mbs_runtime::{Mechanism, mechanism};

mechanism!(FourBar10 {
    doc: "Ten parallelogram loops in a row.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each bar.
    length: Param(1.0_m),
    /// Mass of each bar.
    mass: Param(1.0_kg),
    /// Initial angular velocity of the cranks.
    turning: Param(-1.0_rad_per_s),

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
    crank3: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank4: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank5: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank6: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank7: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank8: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank9: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    crank10: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    coupler1: Bar(mass = mass, length = length),
    coupler2: Bar(mass = mass, length = length),
    coupler3: Bar(mass = mass, length = length),
    coupler4: Bar(mass = mass, length = length),
    coupler5: Bar(mass = mass, length = length),
    coupler6: Bar(mass = mass, length = length),
    coupler7: Bar(mass = mass, length = length),
    coupler8: Bar(mass = mass, length = length),
    coupler9: Bar(mass = mass, length = length),
    coupler10: Bar(mass = mass, length = length),

    bearing0: Revolute(ground.origin, crank0.a),
    bearing1: Revolute(ground.point(1.0 * length, 0.0), crank1.a),
    bearing2: Revolute(ground.point(2.0 * length, 0.0), crank2.a),
    bearing3: Revolute(ground.point(3.0 * length, 0.0), crank3.a),
    bearing4: Revolute(ground.point(4.0 * length, 0.0), crank4.a),
    bearing5: Revolute(ground.point(5.0 * length, 0.0), crank5.a),
    bearing6: Revolute(ground.point(6.0 * length, 0.0), crank6.a),
    bearing7: Revolute(ground.point(7.0 * length, 0.0), crank7.a),
    bearing8: Revolute(ground.point(8.0 * length, 0.0), crank8.a),
    bearing9: Revolute(ground.point(9.0 * length, 0.0), crank9.a),
    bearing10: Revolute(ground.point(10.0 * length, 0.0), crank10.a),
    left1: Revolute(crank0.b, coupler1.a),
    right1: Revolute(crank1.b, coupler1.b),
    left2: Revolute(crank1.b, coupler2.a),
    right2: Revolute(crank2.b, coupler2.b),
    left3: Revolute(crank2.b, coupler3.a),
    right3: Revolute(crank3.b, coupler3.b),
    left4: Revolute(crank3.b, coupler4.a),
    right4: Revolute(crank4.b, coupler4.b),
    left5: Revolute(crank4.b, coupler5.a),
    right5: Revolute(crank5.b, coupler5.b),
    left6: Revolute(crank5.b, coupler6.a),
    right6: Revolute(crank6.b, coupler6.b),
    left7: Revolute(crank6.b, coupler7.a),
    right7: Revolute(crank7.b, coupler7.b),
    left8: Revolute(crank7.b, coupler8.a),
    right8: Revolute(crank8.b, coupler8.b),
    left9: Revolute(crank8.b, coupler9.a),
    right9: Revolute(crank9.b, coupler9.b),
    left10: Revolute(crank9.b, coupler10.a),
    right10: Revolute(crank10.b, coupler10.b),

    b0: Output(crank0.b),
    b0_velocity: Output(crank0.b.velocity),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "four-bar-10",
    title: "Ten four-bar loops in a row",
    source: "LIM benchmark A02, N = 10",
    model: FourBar10::MODEL,
    duration: 20.0,
    step: 1e-2,
    reference: None,
    build: crate::build_scene!(FourBar10),
};
