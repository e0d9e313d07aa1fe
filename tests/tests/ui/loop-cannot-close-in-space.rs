use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    ball: Spherical(ground, body, at = [0.0, 0.0, 0.0]),
    rope: Distance(
        ground.point(10.0, 0.0, 0.0),
        body.point(1.0, 0.0, 0.0),
        length = 1.0_m
    ),
});

fn main() {}
