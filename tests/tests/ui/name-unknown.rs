use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    length: Param(1.0_m),
    bar: Bar(mass = 1.0_kg, length = lenght),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {
    let wrong = Wrong {
        length: 2.0,
        ..Wrong::default()
    };
    let _ = Simulation::new(wrong);
}
