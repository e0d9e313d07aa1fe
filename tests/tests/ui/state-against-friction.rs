use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    crank: Bar(mass = 1.0_kg, length = 0.5_m),
    bearing: Revolute(ground.origin, crank.a),
    charge: State(initial = 0.0_rad_per_s, rate = crank.rate / 1.0_s),
    drag: Friction(crank.rate - charge, load = 1.0_Nm, coefficient = 0.1, regularization_velocity = 0.1_rad_per_s),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
