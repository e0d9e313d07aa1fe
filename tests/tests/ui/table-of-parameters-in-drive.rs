use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    angle: Param([0.0, 1.0, 2.0]),
    program: Table([0.0_s, 1.0_s, 2.0_s], angle, interpolation = Linear),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    motor: Drive(bar.angle, value = program(t)),
});

fn main() {}
