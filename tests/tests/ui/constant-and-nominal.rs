use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    length: Param(0.3_m, nominal = 0.3_m),
    bar: Bar(mass = 1.0_kg, length = length),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
