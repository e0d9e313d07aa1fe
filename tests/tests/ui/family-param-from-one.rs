use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    length: Each(1..4, |i| Param(1.0_m)),
    bar: Each(1..4, |i| Bar(mass = 1.0_kg, length = length[i])),
    pivot: Each(1..4, |i| Revolute(ground.origin, bar[i].a)),
});

fn main() {}
