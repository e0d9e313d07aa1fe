use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    crank: Bar(mass = 1.0_kg, length = 0.5_m),
    bearing: Revolute(ground.origin, crank.a),
    seen: State(rate = (crank.rate - sen) / 0.1_s, initial = 0.0_rad_per_s),
    motor: Torque(crank, value = -1.0_Nm_s * seen),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
