//! Generated code gives no warning: this file does not compile with one, whatever the lints of the workspace are.
#![deny(warnings, missing_docs, unused, nonstandard_style)]
#![deny(clippy::pedantic, clippy::nursery)]

use mbs_runtime::{Simulation, SimulationError, mechanism};

mechanism!(Arm {
    doc: "Without a parameter, with each kind of entry that is read at run time.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    motor: Input(unit = Nm),
    arm: Bar(mass = 1.0_kg, length = 0.5_m),
    shoulder: Revolute(ground.origin, arm.a),
    drive: Torque(on = arm, value = motor),
    angle: Output(arm.angle),
    upright: Event(arm.angle),
    allow: Unused(),
    /// For a spring that is not there yet.
    stiffness: Param(1.0_N_per_m),
    wind: Input(unit = N),
    force: Let(stiffness * 0.1_m),
    mark: Point([0.1_m, 0.2_m]),
    curve: Table([0.0, 1.0, 2.0], [0.0, 1.0, 4.0]),
});

mechanism!(Disc {
    doc: "Without a row, an output, an event or an input.",
    world: Planar(),
    /// Inertia of the disc.
    inertia: Param(1.0_kg_m2),
    turn: Coordinate(0.1_rad),
    disc: Body(
        mass = 1.0_kg,
        inertia = inertia,
        frame = Frame(ground.origin, turn)
    ),
});

#[test]
fn it_runs() -> Result<(), SimulationError> {
    Simulation::new(Arm::default())?.step()?;
    Simulation::new(Disc::default())?.step()?;
    Ok(())
}
