use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    end: Stop(bar.angle, upper = 3.0, dissipation = 0.1_N_m_s, stiffness = 5.0_Nm, onset = 2.0_deg),
});

fn main() {}
