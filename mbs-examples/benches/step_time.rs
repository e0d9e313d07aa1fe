//! Time of a step: hand-written and generated double four-bar in one run, and all scenes with their energy ledger.
//!
//! `cargo bench -p mbs-examples --bench step_time`

#[allow(clippy::needless_range_loop)]
mod handwritten;

use mbs_examples::scenes::double_four_bar::DoubleFourBar;
use mbs_runtime::{Mechanism, Settings, Simulation, SimulationError, TwoLevelStepper};
use std::hint::black_box;
use std::time::Instant;

const STEP: f64 = 1e-3;
/// Both repeat the same second of motion, through the first singular pose.
const STEPS: u32 = 1000;
/// The time is the least of this number of interleaved repeats.
const REPEATS: usize = 40;

fn main() -> Result<(), SimulationError> {
    let (mut by_hand, mut generated) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..REPEATS {
        by_hand = by_hand.min(time_by_hand());
        generated = generated.min(time_generated()?);
    }
    println!("double four-bar, µs a step");
    println!("{by_hand:10.4}  hand-written");
    println!("{generated:10.4}  generated");
    println!("simulated step with energy ledger, µs");
    for scene in mbs_examples::scenes::scenes() {
        let settings = Settings {
            step: scene.step,
            ..Settings::default()
        };
        let mut simulation = (scene.build)(&[], settings)?;
        let steps = (STEPS / 10).max(1);
        let mut least = f64::INFINITY;
        for _ in 0..REPEATS {
            let start = Instant::now();
            for _ in 0..steps {
                simulation.step()?;
            }
            least = least.min(microseconds(start, steps));
        }
        println!("{least:10.4}  {}", scene.name);
    }
    Ok(())
}

fn time_by_hand() -> f64 {
    let mut mechanism = handwritten::DoubleFourBar::new();
    let start = Instant::now();
    for _ in 0..STEPS {
        mechanism.step(black_box(STEP));
    }
    let time = microseconds(start, STEPS);
    let energy = mechanism.energy();
    assert!((energy - 35.835).abs() < 1e-3, "{energy} J");
    time
}

fn time_generated() -> Result<f64, SimulationError> {
    let settings = Settings {
        step: STEP,
        ..Settings::default()
    };
    let simulation = Simulation::with_settings(DoubleFourBar::default(), settings)?;
    let system = DoubleFourBar::default().prepare()?;
    let mut stepper = TwoLevelStepper::new(system, simulation.state().clone(), &settings)?;
    let start = Instant::now();
    for _ in 0..STEPS {
        stepper.step(black_box(STEP))?;
    }
    let time = microseconds(start, STEPS);
    black_box(stepper.state());
    Ok(time)
}

/// Since the start, for each of so many.
fn microseconds(start: Instant, steps: u32) -> f64 {
    1e6 * start.elapsed().as_secs_f64() / f64::from(steps)
}
