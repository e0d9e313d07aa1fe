use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    length: Each(0..4, |i| {
        if i != 2 {
            Param(1.0_m)
        }
    }),
    bar: Bar(mass = 1.0_kg, length = length[0]),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
