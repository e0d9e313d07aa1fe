use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    rod: Bar(
        mass = 1.0_kg,
        from = [0.0, 0.0, 0.0],
        to = [1.0, 0.0, 0.0],
        length = 3.0_m
    ),
    ball: Spherical(ground.origin, rod.a),
});

fn main() {}
