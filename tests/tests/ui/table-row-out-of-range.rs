use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    force: Each((0..2, 0..2), |i, k| Param(1.0_N * k)),
    curve: Table([0.0_m, 1.0_m], force[2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    pull: Force(bar.b, value = [curve(bar.b.x), force[0][0]]),
});

fn main() {}
