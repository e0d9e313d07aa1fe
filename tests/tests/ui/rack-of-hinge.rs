use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    other: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [1.0, 0.0, 0.0]),
    hinge: Revolute(ground, body, at = [0.0, 0.0, 0.0], axis = X),
    wheel: Revolute(ground, other, at = [1.0, 0.0, 0.0], axis = X),
    steering: RackPinion(wheel, hinge, radius = 0.1_m),
});

fn main() {}
