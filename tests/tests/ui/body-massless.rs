use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    wheel: Body(mass = 0.0_kg, inertia = 0.0_kg_m2),
    guide: PointOnLine(wheel.origin, ground.origin),
});

fn main() {}
