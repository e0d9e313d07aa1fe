use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    slide: Prismatic(ground, body, at = [0.0, 0.0, 0.0], axis = X),
    spring: TorsionSpring(slide, stiffness = 1.0_Nm),
});

fn main() {}
