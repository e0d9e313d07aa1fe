use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
