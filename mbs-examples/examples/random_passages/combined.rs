//! Mechanisms with a second difficulty beside the singular pose, and two without such a pose.

use mbs_runtime::mechanism;

mechanism!(Driven {
    doc: "A folding slider-crank whose crank is driven: a row on time.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = -phase, rate = -rate),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    drive: Drive(crank.angle, value = phase + rate * t),
    brake: TorsionSpring(crank, rod, damping = damping),
    astray: Output(rod.b.x - 2.0 * crank.b.x),
});

mechanism!(Shaken {
    doc: "A parallelogram on a base that a drive shakes.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    base: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        velocity = [0.5_m_per_s, 0.0]
    ),
    crank0: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    crank1: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    coupler: Bar(mass = 1.0_kg, length = 1.0_m),
    upright: Holonomic(base.angle),
    rail: PointOnLine(base.origin, ground.origin, axis = X),
    shaking: Drive(base.origin.x, value = 0.1_m * sin(5.0_rad_per_s * t)),
    pivot0: Revolute(base.origin, crank0.a),
    pivot1: Revolute(base.point(1.0, 0.0), crank1.a),
    pin0: Revolute(crank0.b, coupler.a),
    pin1: Revolute(crank1.b, coupler.b),
    brake: TorsionSpring(base, crank0, damping = damping),
    astray: Output(crank1.b.y - crank0.b.y),
});

mechanism!(OnSleigh {
    doc: "A parallelogram on a sleigh with a knife edge: a nonholonomic row.",
    world: Planar(),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    turning: Let(0.3_rad_per_s),
    sleigh: Body(
        mass = 20.0_kg,
        inertia = 8.0_kg_m2,
        center_of_mass = [0.35_m, 0.0],
        rate = turning
    ),
    edge: Nonholonomic(dot(sleigh.velocity, sleigh.y)),
    crank0: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    crank1: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    coupler: Bar(mass = 1.0_kg, length = 1.0_m, rate = turning),
    pivot0: Revolute(sleigh.origin, crank0.a),
    pivot1: Revolute(sleigh.point(1.0, 0.0), crank1.a),
    pin0: Revolute(crank0.b, coupler.a),
    pin1: Revolute(crank1.b, coupler.b),
    brake: TorsionSpring(sleigh, crank0, damping = damping),
    astray: Output(dot(crank1.b - crank0.b, sleigh.y)),
});

/// Three cranks and two couplers of this mass, pushed by a torque that the program changes.
macro_rules! pushed {
    ($name:ident, $mass:literal) => {
        mechanism!($name {
            doc: "Three cranks and two couplers; a torque on the first crank jumps.",
            world: Planar(gravity = [0.0, -9.81_m_per_s2]),
            phase: Param(40.0_deg),
            rate: Param(1.0_rad_per_s),
            damping: Param(0.0),
            push: Input(0.0_N_m),
            crank0: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
            crank1: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
            crank2: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
            coupler1: Bar(mass = $mass, length = 1.0_m),
            coupler2: Bar(mass = $mass, length = 1.0_m),
            pivot0: Revolute(ground.origin, crank0.a),
            pivot1: Revolute(ground.point(1.0, 0.0), crank1.a),
            pivot2: Revolute(ground.point(2.0, 0.0), crank2.a),
            pin1a: Revolute(crank0.b, coupler1.a),
            pin1b: Revolute(crank1.b, coupler1.b),
            pin2a: Revolute(crank1.b, coupler2.a),
            pin2b: Revolute(crank2.b, coupler2.b),
            motor: Torque(crank0, value = push),
            brake: TorsionSpring(ground, crank0, damping = damping),
            astray: Output(abs(crank1.b.y - crank0.b.y) + abs(crank2.b.y - crank0.b.y)),
        });
    };
}
pushed!(Pushed, 1.0_kg);
pushed!(Light, 1.0e-4_kg);

mechanism!(FastRotor {
    doc: "A rotor of 1000 rad/s on a pendulum.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    arm: Let([cos(phase), 0.0, sin(phase)]),
    pendulum: Body(
        mass = 1.0_kg,
        inertia = diag(0.05, 0.05, 0.05),
        at = 0.5_m * arm,
        velocity = [0.0, 0.5_m * rate, 0.0]
    ),
    rotor: Body(
        mass = 1.0_kg,
        inertia = diag(0.02, 0.01, 0.01),
        at = 1.0_m * arm,
        orientation = turn([0.0, 1.0, 0.0], -phase),
        angular_velocity = 1000.0_rad_per_s * arm,
        velocity = [0.0, rate * 1.0_m, 0.0]
    ),
    pivot: Spherical(ground, pendulum, at = [0.0, 0.0, 0.0]),
    shaft: Revolute(pendulum, rotor, at = 1.0_m * arm, axis = arm),
    brake: TorsionSpring(shaft, damping = 1.0e-3 * damping),
    astray: Output(norm(rotor.origin) - 1.0_m),
});
