use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Each(0..3, |i| Each(0..2, |j| Bar(mass = 1.0_kg, length = 1.0_m))),
});

fn main() {}
