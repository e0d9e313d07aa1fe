use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    end: Stop(
        ground.point(1.0_m, 0.0_m).x,
        upper = 3.0_m,
        stiffness = 5.0_N_per_m,
        onset = 2.0_mm
    ),
});

fn main() {}
