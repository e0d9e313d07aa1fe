use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = Sphere(0.1_m)),
    pivot: Revolute(ground.origin, body.origin),
});

fn main() {}
