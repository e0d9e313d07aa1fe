use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    x: Coordinate(1.0_m),
    cart: Particle(position = [x, 0.0]),
});

fn main() {}
