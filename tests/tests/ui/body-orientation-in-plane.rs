use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    body: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        orientation = turn(X, 0.1)
    ),
    pivot: Revolute(ground.origin, body.origin),
});

fn main() {}
