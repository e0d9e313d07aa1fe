//! An arm of three joints with computed torque: the tip follows a program, while the arm starts at rest beside it.
//!
//! `cargo run --release -p mbs-parts --features large --example arm`

use mbs_runtime::nalgebra::Vector3;
use mbs_runtime::{Simulation, SimulationError, mechanism};

mechanism!(Arm {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),
    torque: Each(0..3, |i| Input(unit = Nm)),
    tower: Bar(mass = 8.0_kg, to = [0.0, 0.0, 0.5], radius = 0.08_m),
    upper: Bar(
        mass = 4.0_kg,
        from = tower.b,
        to = [0.6, 0.0, 0.5],
        radius = 0.05_m
    ),
    forearm: Bar(
        mass = 2.0_kg,
        from = upper.b,
        to = [1.2, 0.0, 0.5],
        radius = 0.04_m
    ),
    swivel: Revolute(ground, tower, at = tower.a, axis = Z),
    shoulder: Revolute(tower, upper, at = tower.b, axis = Y),
    elbow: Revolute(upper, forearm, at = upper.b, axis = Y),
    turn: Torque(swivel, value = torque[0]),
    lift: Torque(shoulder, value = torque[1]),
    bend: Torque(elbow, value = torque[2]),
    angles: Output([swivel.angle, shoulder.angle, elbow.angle]),
    rates: Output([swivel.rate, shoulder.rate, elbow.rate]),
    tip: Output(forearm.b),
});

/// Angles, rates and accelerations of the program.
pub fn program(t: f64) -> [Vector3<f64>; 3] {
    let (size, frequency) = (Vector3::new(0.8, 0.3, 0.5), Vector3::new(1.0, 2.0, 3.0));
    let middle = Vector3::new(0.0, -0.5, 1.0);
    let of = |f: fn(f64, f64) -> f64| size.zip_map(&frequency, |a, w| a * f(w, t));
    [
        middle + of(|w, t| (w * t).sin()),
        of(|w, t| w * (w * t).cos()),
        of(|w, t| -w * w * (w * t).sin()),
    ]
}

/// Runs until `until` with torques each millisecond; the distance of the angles from the program then, rad.
pub fn follow(until: f64) -> Result<f64, SimulationError> {
    let mut arm: ArmSimulation = Simulation::start(Arm::default())
        .hold("shoulder.angle", -0.4)
        .hold("elbow.angle", 1.2)
        .begin()?;
    let mut dynamics = arm.dynamics()?;
    while arm.time() < until {
        let (t, outputs) = (arm.time(), arm.outputs());
        let [angles, rates, accelerations] = program(t);
        let wanted =
            accelerations + 20.0 * (rates - outputs.rates) + 100.0 * (angles - outputs.angles);
        // v̇₀ is the acceleration without torques, and M(v̇ − v̇₀) gives v̇.
        dynamics.evaluate(t, arm.positions(), arm.velocities())?;
        let torque = dynamics.mass_matrix() * (wanted - dynamics.accelerations());
        arm.inputs_mut().torque = torque.into();
        arm.run_until(t + 1e-3)?;
    }
    Ok((program(until)[0] - arm.outputs().angles).norm())
}

fn main() -> Result<(), SimulationError> {
    for until in [0.0, 0.2, 0.5, 1.0, 2.0] {
        println!("{until:>4} s: {:.1e} rad", follow(until)?);
    }
    Ok(())
}
