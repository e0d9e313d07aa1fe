use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    crank: Bar(mass = 1.0_kg, length = 1.0_m),
    coupler: Bar(mass = 1.0_kg, length = 1.0_m),
    rocker: Bar(mass = 1.0_kg, length = 1.0_m),
    left: Revolute(ground.origin, crank.a),
    top: Revolute(crank.b, coupler.a),
    other: Revolute(coupler.b, rocker.a),
    right: Revolute(ground.point(5.0_m, 0.0), rocker.b),
});

fn main() {}
