use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Each(0..3, |i| Bar(mass = 1.0_kg, length = 1.0_m)),
    base: Revolute(ground.origin, bar[0].a),
    pin: Each(0..3, |i| Revolute(bar[i - 1].b, bar[i].a)),
});

fn main() {}
