use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    r#lever: Param(1.0_m),
    bar: Bar(mass = 1.0_kg, length = lever),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
