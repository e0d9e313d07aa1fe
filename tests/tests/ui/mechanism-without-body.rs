use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong);

fn main() {
    let _ = Simulation::new(Wrong::default());
}
