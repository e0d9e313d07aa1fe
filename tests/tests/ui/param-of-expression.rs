use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    lever: Param(1.0_m),
    half: Param(0.5 * lever),
    bar: Bar(mass = 1.0_kg, length = half),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
