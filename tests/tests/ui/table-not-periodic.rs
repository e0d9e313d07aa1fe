use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    curve: Table([0.0_deg, 180.0_deg, 270.0_deg], [0.0_Nm, 3.0_Nm, 1.0_Nm], beyond = Periodic),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    motor: Torque(bar, value = curve(bar.angle)),
});

fn main() {}
