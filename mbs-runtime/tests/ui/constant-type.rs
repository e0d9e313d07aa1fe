use mbs_runtime::mechanism;

const LENGTH: f32 = 0.3;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    length: Param(LENGTH, nominal = 0.3_m),
    bar: Bar(mass = 1.0_kg, length = length),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
