use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, orientation = quaternion(0.0, 0.0, 0.0, 0.0)),
    hinge: Revolute(ground, body, at = [0.0, 0.0, 0.0]),
});

fn main() {}
