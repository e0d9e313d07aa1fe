use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Each([(1.0_kg, 1.0_m), 2.0_kg], |(mass, length)| Bar(
        mass = mass,
        length = length
    )),
});

fn main() {}
