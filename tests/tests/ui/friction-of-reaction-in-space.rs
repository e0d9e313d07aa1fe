use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [1.0_m, 0.0, 0.0]),
    hinge: Revolute(ground, body, at = [0.0_m, 0.0, 0.0], axis = Y),
    pad: Friction(hinge.rate, load = 0.1_m * norm(hinge.force), coefficient = 0.3, regularization_velocity = 0.1),
});

fn main() {}
