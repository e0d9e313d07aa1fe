use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    wheel: Body(mass = 1.0_kg, inertia = 0.0_kg_m2),
    pivot: Revolute(ground.origin, wheel.point(1.0_m, 0.0_m)),
});

fn main() {}
