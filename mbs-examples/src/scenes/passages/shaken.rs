//! A parallelogram on a base that a drive shakes.

use mbs_runtime::mechanism;

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
