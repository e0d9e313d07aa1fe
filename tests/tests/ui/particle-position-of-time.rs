use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    x: Coordinate(1.0_m),
    cart: Particle(mass = 1.0_kg, position = [x + 1.0_m_per_s * t, 0.0]),
});

fn main() {}
