//! Instructions of a step of the double four-bar, hand-written and generated, counted by valgrind's callgrind: exact and
//! repeatable, whatever else the machine is doing.
//!
//! `cargo bench -p mbs-examples --bench step_instructions` (needs valgrind on the path)

#[allow(clippy::needless_range_loop)]
mod handwritten;

use mbs_examples::scenes::double_four_bar::DoubleFourBar;
use mbs_runtime::{Mechanism, Settings, Simulation, TwoLevelStepper};
use std::hint::black_box;
use std::process::Command;

/// The count is the difference between runs of these lengths, so that start-up cancels.
const STEPS: [u64; 2] = [2_000, 12_000];

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, mode, name, step, steps] = arguments.as_slice()
        && mode == "--count"
    {
        let (Ok(step), Ok(steps)) = (step.parse(), steps.parse()) else {
            return;
        };
        return run(name, step, steps);
    }
    println!(
        "instructions a step of the double four-bar, over {} steps",
        STEPS[1] - STEPS[0]
    );
    println!(
        "{:>8} {:>14} {:>12} {:>8}",
        "h, s", "hand-written", "generated", "ratio"
    );
    for step in [1e-3, 1e-2] {
        match (count("hand-written", step), count("generated", step)) {
            (Some(hand), Some(generated)) => println!(
                "{step:>8} {hand:>14.1} {generated:>12.1} {:>8.3}",
                generated / hand
            ),
            _ => {
                println!("callgrind gave no count: is valgrind installed?");
                return;
            }
        }
    }
}

fn run(name: &str, step: f64, steps: u64) {
    if name == "hand-written" {
        let mut mechanism = handwritten::DoubleFourBar::new();
        for _ in 0..steps {
            mechanism.step(black_box(step));
        }
        println!("{}", mechanism.energy());
        return;
    }
    let Ok(system) = DoubleFourBar::default().prepare() else {
        return;
    };
    let Ok(simulation) = Simulation::new(DoubleFourBar::default()) else {
        return;
    };
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let Ok(mut stepper) = TwoLevelStepper::new(system, simulation.state().clone(), &settings)
    else {
        return;
    };
    for _ in 0..steps {
        if let Err(error) = stepper.step(black_box(step)) {
            println!("{error}");
            return;
        }
    }
    println!("{:?}", stepper.state().positions);
}

fn count(name: &str, step: f64) -> Option<f64> {
    let totals = STEPS.map(|steps| callgrind(name, step, steps));
    Some((totals[1]? - totals[0]?) / (STEPS[1] - STEPS[0]) as f64)
}

fn callgrind(name: &str, step: f64, steps: u64) -> Option<f64> {
    let program = std::env::current_exe().ok()?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(["--count", name, &step.to_string(), &steps.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(' ').next()?.trim().parse().ok()
}
