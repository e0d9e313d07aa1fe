use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    mass: Param([1.0_kg, 2.0_kg]),

    bar: Bar(mass = mass, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {}
