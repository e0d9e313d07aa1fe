use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    grip: Input(0.3),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    pad: Friction(bar.rate, load = 1.0_N_m, coefficient = grip, regularization_velocity = 0.1_rad_per_s),
});

fn main() {}
