use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Each([1.0_m, 2.0_kg, 3.0_m], |length| Bar(
        mass = 1.0_kg,
        length = 2.0 * length
    )),
    pivot: Each(0..3, |i| Revolute(ground.origin, bar[i].a)),
});

fn main() {}
