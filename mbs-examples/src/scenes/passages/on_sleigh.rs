//! A parallelogram on a sleigh with a knife edge.

use mbs_runtime::mechanism;

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
