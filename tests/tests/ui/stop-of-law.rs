use mbs_runtime::mechanism;

fn height(x: [f64; 1]) -> (f64, [f64; 1]) {
    (x[0], [1.0])
}

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    end: Stop(law(height, bar.b.x), upper = 3.0, stiffness = 5.0, onset = 0.1),
});

fn main() {}
