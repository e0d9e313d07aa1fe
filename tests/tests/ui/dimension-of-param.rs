use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    weight: Param(9.81_N),
    bar: Bar(mass = weight, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {
    let wrong = Wrong { weight: 20.0 };
    let _ = Simulation::new(wrong);
}
