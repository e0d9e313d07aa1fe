use mbs_runtime::{Simulation, mechanism};

mechanism!(Arm {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    motor: Input(unit = Nm),
    arm: Bar(mass = 1.0_kg, length = 0.5_m),
    shoulder: Revolute(ground.origin, arm.a),
    drive: Torque(on = arm, value = motor),
    height: Output(arm.b.y),
});

/// Inputs and outputs are fields.
fn main() {
    let mut simulation: ArmSimulation = Simulation::new(Arm {}).unwrap();
    simulation.inputs_mut().motr = 1.0;
    println!("{}", simulation.outputs().heigth);
}
