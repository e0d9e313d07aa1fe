//! A slider-crank with rods of equal length, free and driven.

use mbs_runtime::mechanism;

mechanism!(SliderCrank {
    doc: "Crank and rod of equal length: when the crank is upright the slider may stay, or go on.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = -phase, rate = -rate),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    brake: TorsionSpring(ground, crank, damping = damping),
    astray: Output(rod.b.x - 2.0 * crank.b.x),
});

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
