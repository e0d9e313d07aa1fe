use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    pivot: Revolute(ground.origin, body.point(law(reach, 1.0), 0.0)),
});

fn main() {}
