use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.5),
    bearing: Revolute(ground.origin, crank.a),
    rod: Bar(mass = 1.0_kg, from = crank.b, to = [2.0_m, 0.0_m]),
    pin: Revolute(crank.b, rod.a),
});

fn main() {}
