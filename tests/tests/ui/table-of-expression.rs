use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    most: Param(3.0_N),
    curve: Table([0.0_m, 1.0_m], [0.0_N, 2.0 * most]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    pull: Force(bar.b, value = [curve(bar.b.x), 0.0]),
});

fn main() {}
