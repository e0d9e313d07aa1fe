use mbs_runtime::mechanism;

mechanism!(Wrong {
    allow: Everything(),
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    hinge: Revolute(ground, body, at = [0.0, 0.0, 0.0], axis = X),
});

fn main() {}
