use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    crank: Bar(mass = 1.0_kg, length = 0.5_m),
    bearing: Revolute(ground.origin, crank.a),
    charge: State(rate = crank.rate),
    bob: Particle(mass = 1.0_kg * charge),
    pin: Revolute(bob, crank.b),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
