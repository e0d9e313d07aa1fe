use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    wheel: Body(mass = 1.0_kg),
    pivot: Revolute(ground.origin, wheel.origin),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
