use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    length: Each(0..2, |i| {
        if i == 0 {
            Param(1.0_m)
        } else {
            Let(2.0 * length[0])
        }
    }),
    bar: Bar(mass = 1.0_kg, length = length[1]),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
