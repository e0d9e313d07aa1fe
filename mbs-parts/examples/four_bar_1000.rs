//! A thousand four-bar loops in a row, beside forty: what a step costs for each loop.
//!
//! `cargo run --release -p mbs-parts --features large --example four_bar_1000 -- 0.2 1e-3`, with the time to simulate and
//! the step. The declaration has as many lines for any number of loops, and so has the generated code but for its tables.
//! Before the first step the start is assembled: it has a column of its own.

use mbs_runtime::{AnySimulation, Settings, Simulation, mechanism};
use std::time::Instant;

macro_rules! four_bars {
    ($name:ident, $count:tt) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2]),
            length: Param(1.0_m),
            mass: Param(1.0_kg),
            turning: Param(-1.0_rad_per_s),
            crank: Each(0..=$count, |i| Bar(
                mass = mass,
                length = length,
                angle = 90.0_deg,
                rate = turning
            )),
            coupler: Each(1..=$count, |i| Bar(mass = mass, length = length)),
            bearing: Each(0..=$count, |i| Revolute(
                ground.point(i * length, 0.0),
                crank[i].a
            )),
            left: Each(1..=$count, |i| Revolute(crank[i - 1].b, coupler[i].a)),
            right: Each(1..=$count, |i| Revolute(crank[i].b, coupler[i].b)),
            tip: Output(crank[0].b),
        });
    };
}

four_bars!(FourBar40, 40);
four_bars!(FourBar1000, 1000);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut numbers = [0.2, 1e-3];
    for (number, text) in numbers.iter_mut().zip(std::env::args().skip(1)) {
        *number = text.parse()?;
    }
    let [duration, step] = numbers;
    let settings = Settings {
        step,
        ..Settings::default()
    };
    println!("loops  start, s  a step, µs  a step and loop, µs  energy error, J");
    let begin = Instant::now();
    let simulation = Simulation::with_settings(FourBar40::default(), settings)?;
    run(40, begin, simulation, duration)?;
    let begin = Instant::now();
    let simulation = Simulation::with_settings(FourBar1000::default(), settings)?;
    run(1000, begin, simulation, duration)
}

/// Simulates, and prints a line.
fn run(
    loops: u32,
    begin: Instant,
    mut simulation: impl AnySimulation,
    duration: f64,
) -> Result<(), Box<dyn std::error::Error>> {
    let start = begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    simulation.run_until(duration)?;
    let steps = simulation.report().steps as f64;
    let each = 1e6 * begin.elapsed().as_secs_f64() / steps;
    println!(
        "{loops:>5}  {start:>8.2}  {each:>10.1}  {:>19.2}  {:>15.1e}",
        each / f64::from(loops),
        simulation.energy().error
    );
    Ok(())
}
