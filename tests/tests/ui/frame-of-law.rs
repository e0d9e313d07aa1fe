use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    theta: Coordinate(0.1_rad),
    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, frame = Frame([law(path, theta), 0.0], theta)),
});

fn main() {}
