use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    still: Event(rate(bar.b.velocity).x),
});

fn main() {}
