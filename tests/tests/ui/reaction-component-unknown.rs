use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(),
    rod: Each(0..3, |i| Bar(mass = 1.0_kg, length = 1.0_m)),
    pivot: Each(0..3, |i| Revolute(ground.point(i * 1.0_m, 0.0), rod[i].a)),
    load: Output(pivot[1].reaction.fz),
});

fn main() {}
