use mbs_runtime::mechanism;

mechanism!(FourBar {
    world: Planar(),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = Exactly(60.0_deg)),
    coupler: Bar(mass = 1.0_kg, length = 2.0_m),
    rocker: Bar(mass = 1.0_kg, length = 1.5_m, angle = Exactly(-80.0_deg)),
    left: Revolute(ground.origin, crank.a),
    top: Revolute(crank.b, coupler.a),
    other: Revolute(coupler.b, rocker.a),
    right: Revolute(ground.point(2.0_m, 0.0), rocker.b),
});

fn main() {}
