use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    slip: Holonomic(bar.b.velocity.x),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
