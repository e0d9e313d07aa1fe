use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    sledge: Body(mass = 1.0_kg, inertia = 1.0_kg_m2),
    guide: Prismatic(ground.origin, sledge.origin),
    turn: Torque(guide, value = 1.0_N_m),
});

fn main() {}
