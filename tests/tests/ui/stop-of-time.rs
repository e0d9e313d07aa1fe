use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    end: Stop(bar.angle - 1.0_rad_per_s * t, upper = 3.0, stiffness = 5.0_Nm, onset = 2.0_deg),
});

fn main() {}
