//! What `main.c` computes, in Rust; the bits of all numbers. With `header` as its argument it writes the header.

use mbs_c::SliderCrank;
use mbs_runtime::{Mechanism, Settings, Simulation, SimulationError, c_interface};

fn main() -> Result<(), SimulationError> {
    if std::env::args().nth(1).as_deref() == Some("header") {
        print!(
            "{}",
            c_interface::header("slider_crank", SliderCrank::MODEL)
        );
        return Ok(());
    }
    let settings = Settings {
        step: 1e-3,
        placement: false,
        ..Settings::default()
    };
    let mechanism = SliderCrank {
        rod_length: 0.45,
        ..SliderCrank::default()
    };
    let mut simulation = Simulation::with_settings(mechanism, settings)?;
    for _ in 0..1000 {
        let speed = simulation.outputs().speed;
        simulation.inputs_mut().motor_torque = 0.8 * (12.0 - speed);
        simulation.step()?;
    }
    let (outputs, energy) = (simulation.outputs(), simulation.energy());
    let show = |name: &str, value: f64| println!("{name} {:016x} {value:.6}", value.to_bits());
    show("time", simulation.time());
    show("stroke", outputs.stroke);
    show("speed", outputs.speed);
    show("work", energy.nonconservative_work);
    show("error", energy.error);
    for (i, position) in simulation.positions().iter().enumerate() {
        show(&format!("q{i}"), *position);
    }
    Ok(())
}
