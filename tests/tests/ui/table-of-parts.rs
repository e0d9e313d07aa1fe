use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Each(0..2, |i| Bar(mass = 1.0_kg, length = 1.0_m)),
    pivot: Each(0..2, |i| Revolute(ground.origin, bar[i].a)),
    curve: Table([0.0_m, 1.0_m], bar),
    pull: Force(bar[0].b, value = [curve(bar[1].b.x), 0.0]),
});

fn main() {}
