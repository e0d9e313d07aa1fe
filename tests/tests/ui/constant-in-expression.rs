use mbs_runtime::mechanism;

const LENGTH: f64 = 0.3;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = LENGTH),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
