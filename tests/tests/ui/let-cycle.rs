use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    first: Let(2.0 * second),
    second: Let(0.5 * first),
    bar: Bar(mass = 1.0_kg, length = first),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
