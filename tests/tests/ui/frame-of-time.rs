use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    theta: Coordinate(0.0_rad),
    bar: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        frame = Frame([0.0_m, 0.0_m], theta + 1.0_rad_per_s * t)
    ),
});

fn main() {}
