use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
