use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    place: Param([0.0_m, 1.0_m, 0.5_m]),
    curve: Table(place, [0.0_N, 1.0_N, 2.0_N]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    pull: Force(bar.b, value = [curve(bar.b.x), 0.0]),
});

fn main() {}
