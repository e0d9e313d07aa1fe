use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    one: Particle(mass = 1.0_kg, at = other.origin),
    other: Particle(mass = 1.0_kg, at = one.origin),
    spring: SpringDamper(one.origin, other.origin, stiffness = 1.0_N_per_m),
});

fn main() {}
