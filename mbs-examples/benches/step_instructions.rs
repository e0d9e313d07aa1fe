//! Instructions of a step of the double four-bar and of Andrews' mechanism, hand-written and generated, and of every
//! scene, counted by valgrind's callgrind. The counts are exact and repeatable; other work of the machine has no
//! effect.
//!
//! `cargo bench -p mbs-examples --bench step_instructions [-- --csv DIR]` (needs valgrind on the path; a bench runs in
//! its package, so that DIR is `../book/src/results/readme`)

#[allow(clippy::needless_range_loop)]
mod handwritten;

use cpu_time::ProcessTime;
use mbs_examples::pages::record::{File, Recorder};
use mbs_examples::scene::Scene;
use mbs_examples::scenes::{andrews::Andrews, double_four_bar::DoubleFourBar, scenes};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{Mechanism, Settings, Simulation, System, TwoLevelStepper};
use std::hint::black_box;
use std::process::Command;

/// The count is the difference between runs with these numbers of steps, so that the start cancels.
const STEPS: [u64; 2] = [2_000, 12_000];
/// The same for the table of all scenes.
const SHORT: [u64; 2] = [20, 220];

/// Columns of the file; the first two identify a count.
const COLUMNS: [&str; 7] = [
    "name",
    "step_s",
    "velocities",
    "rows",
    "instructions",
    "estimated",
    "time_us",
];
/// Times are the least of this number of interleaved repeats.
const REPEATS: usize = 40;

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, mode, name, step, steps] = arguments.as_slice()
        && mode == "--count"
    {
        let (Ok(step), Ok(steps)) = (step.parse(), steps.parse()) else {
            return Ok(());
        };
        run(name, step, steps);
        return Ok(());
    }
    let recorder = Recorder::new("cargo bench -p mbs-examples --bench step_instructions")?;
    let mut file = recorder.file("instructions.csv", &COLUMNS, 2)?;
    println!(
        "after {} steps the two agree to {:.1e} m",
        STEPS[0],
        disagreement(1e-3, STEPS[0])
    );
    println!(
        "instructions a step of the double four-bar, over {} steps",
        STEPS[1] - STEPS[0]
    );
    println!(
        "{:>8} {:>14} {:>12} {:>8}",
        "h, s", "hand-written", "generated", "ratio"
    );
    for step in [1e-3, 1e-2] {
        match (
            count("hand-written", step, STEPS),
            count("generated", step, STEPS),
        ) {
            (Some(hand), Some(generated)) => {
                println!(
                    "{step:>8} {hand:>14.1} {generated:>12.1} {:>8.3}",
                    generated / hand
                );
                let times = times(["hand-written", "generated"], step);
                println!("{:>8} {:>14.4} {:>12.4} µs", "", times[0], times[1]);
                let counts = [("hand-written", hand), ("generated", generated)];
                for ((name, count), time) in counts.into_iter().zip(times) {
                    file.put(line(
                        name,
                        step,
                        count,
                        ["6", "5", "", &format!("{time:.5}")],
                    ))?;
                }
            }
            _ => return Err("callgrind gave no count: is valgrind installed?".to_owned()),
        }
    }
    andrews(&mut file)?;
    every_scene(&mut file)?;
    growth();
    Ok(())
}

/// A row of the file: velocities, rows, the operations estimated by the compiler and the time are in `rest`.
fn line(name: &str, step: f64, count: f64, rest: [&str; 4]) -> Vec<String> {
    let [velocities, rows, estimated, time] = rest.map(str::to_owned);
    let count = format!("{count:.1}");
    let step = format!("{step:e}");
    vec![
        name.to_owned(),
        step,
        velocities,
        rows,
        count,
        estimated,
        time,
    ]
}

/// Processor time of a step, µs.
fn times(names: [&str; 2], step: f64) -> [f64; 2] {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..REPEATS {
        for (name, least) in names.iter().zip(&mut least) {
            let begin = ProcessTime::now();
            advance(name, step, STEPS[1]);
            *least = least.min(begin.elapsed().as_secs_f64());
        }
    }
    least.map(|time| 1e6 * time / STEPS[1] as f64)
}

/// Runs the double four-bar, hand-written or generated; returns its last coordinates.
fn advance(name: &str, step: f64, steps: u64) -> f64 {
    if name == "hand-written" {
        let mut mechanism = handwritten::DoubleFourBar::new();
        for _ in 0..steps {
            mechanism.step(black_box(step));
        }
        return black_box(mechanism.energy());
    }
    let Some(mut stepper) = stepper(step) else {
        return f64::NAN;
    };
    for _ in 0..steps {
        if stepper.step(black_box(step)).is_err() {
            return f64::NAN;
        }
    }
    black_box(stepper.state().positions[0])
}

/// The same integrator on the equations written by hand and on the generated ones.
fn andrews(file: &mut File) -> Result<(), String> {
    const STEP: f64 = 1e-6;
    println!();
    println!(
        "Andrews' mechanism: after {} steps the two agree to {:.1e} rad",
        SHORT[1],
        andrews_disagreement(STEP, SHORT[1])
    );
    let counts = ["andrews-hand", "andrews-generated"].map(|name| count(name, STEP, SHORT));
    if let [Some(hand), Some(generated)] = counts {
        println!(
            "{STEP:>8} {hand:>14.1} {generated:>12.1} {:>8.3}",
            generated / hand
        );
        for (name, count) in [("andrews-hand", hand), ("andrews-generated", generated)] {
            file.put(line(name, STEP, count, ["7", "6", "", ""]))?;
        }
    }
    Ok(())
}

fn andrews_disagreement(step: f64, steps: u64) -> f64 {
    let settle = |end: Option<SVector<f64, 7>>| end.unwrap_or(SVector::repeat(f64::NAN));
    let hand = settle(run_andrews(handwritten::Andrews, step, steps));
    let generated = Andrews::default().prepare().ok();
    let generated = settle(generated.and_then(|system| run_andrews(system, step, steps)));
    let pairs = hand.iter().zip(&generated);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The angles after some steps from the scene's start.
fn run_andrews<S: System<7, 7, 6>>(system: S, step: f64, steps: u64) -> Option<SVector<f64, 7>> {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let simulation = Simulation::with_settings(Andrews::default(), settings).ok()?;
    let start = simulation.state().clone();
    let mut stepper = TwoLevelStepper::new(system, start, &settings).ok()?;
    for _ in 0..steps {
        stepper.step(black_box(step)).ok()?;
    }
    Some(stepper.state().positions)
}

/// Instructions of a step of every scene at its own step size, and the operations estimated by the compiler.
fn every_scene(file: &mut File) -> Result<(), String> {
    println!();
    println!(
        "{:<22} {:>9} {:>10} {:>5} {:>13} {:>11}",
        "scene", "h, s", "velocities", "rows", "instructions", "estimated"
    );
    for scene in scenes() {
        let Some(instructions) = count(scene.name, scene.step, SHORT) else {
            continue;
        };
        let candidates = scene.model.candidates.iter();
        let taken = candidates
            .filter(|candidate| candidate.taken)
            .find_map(|candidate| candidate.operations);
        println!(
            "{:<22} {:>9} {:>10} {:>5} {instructions:>13.0} {:>11}",
            scene.name,
            scene.step,
            scene.model.velocities.len(),
            scene.model.rows.len(),
            taken.map_or_else(String::new, |operations| operations.to_string())
        );
        let sizes = [scene.model.velocities.len(), scene.model.rows.len()];
        let [velocities, rows] = sizes.map(|size| size.to_string());
        let estimated = taken.map_or_else(String::new, |operations| operations.to_string());
        let rest = [velocities.as_str(), &rows, &estimated, ""];
        file.put(line(scene.name, scene.step, instructions, rest))?;
    }
    Ok(())
}

/// Growth of the instructions with the number of loops in a row of four-bars: the exponent between each two numbers,
/// for each step.
fn growth() {
    let chains = [
        ("double-four-bar", 2.0_f64),
        ("four-bar-10", 10.0),
        ("four-bar-40", 40.0),
    ];
    println!();
    println!("exponent of the instructions of a step in the number of loops");
    println!(
        "{:>8} {:>10} {:>10} {:>10}",
        "h, s", "2 to 10", "10 to 40", "2 to 40"
    );
    for step in [1e-3, 1e-2] {
        let counts = chains.map(|(name, _)| count(name, step, SHORT).unwrap_or(f64::NAN));
        let exponent =
            |i: usize, j: usize| (counts[j] / counts[i]).ln() / (chains[j].1 / chains[i].1).ln();
        println!(
            "{step:>8} {:>10.3} {:>10.3} {:>10.3}",
            exponent(0, 1),
            exponent(1, 2),
            exponent(0, 2)
        );
    }
}

fn run_scene(scene: &Scene, step: f64, steps: u64) {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let Ok(mut simulation) = (scene.build)(&[], settings) else {
        return;
    };
    for _ in 0..steps {
        if let Err(error) = simulation.step() {
            // A shorter run is not counted as one of all steps.
            eprintln!("{error}");
            std::process::exit(1);
        }
    }
    println!("{:?}", simulation.output_values());
}

/// The largest difference of the coordinates of the two mechanisms, which tests that they are the same mechanism.
fn disagreement(step: f64, steps: u64) -> f64 {
    let Some(mut stepper) = stepper(step) else {
        return f64::NAN;
    };
    let mut mechanism = handwritten::DoubleFourBar::new();
    for _ in 0..steps {
        mechanism.step(step);
        if stepper.step(step).is_err() {
            return f64::NAN;
        }
    }
    let pairs = mechanism.q.iter().zip(&stepper.state().positions);
    pairs
        .map(|(hand, generated)| (hand - generated).abs())
        .fold(0.0, f64::max)
}

fn stepper(step: f64) -> Option<TwoLevelStepper<<DoubleFourBar as Mechanism>::System, 6, 6, 5>> {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let simulation = Simulation::with_settings(DoubleFourBar::default(), settings).ok()?;
    let system = DoubleFourBar::default().prepare().ok()?;
    TwoLevelStepper::new(system, simulation.state().clone(), &settings).ok()
}

fn run(name: &str, step: f64, steps: u64) {
    if name == "andrews-hand" {
        println!("{:?}", run_andrews(handwritten::Andrews, step, steps));
        return;
    }
    if name == "andrews-generated" {
        let system = Andrews::default().prepare().ok();
        println!(
            "{:?}",
            system.and_then(|system| run_andrews(system, step, steps))
        );
        return;
    }
    if let Some(scene) = scenes().iter().find(|scene| scene.name == name) {
        return run_scene(scene, step, steps);
    }
    println!("{}", advance(name, step, steps));
}

fn count(name: &str, step: f64, steps: [u64; 2]) -> Option<f64> {
    let totals = steps.map(|steps| callgrind(name, step, steps));
    Some((totals[1]? - totals[0]?) / (steps[1] - steps[0]) as f64)
}

fn callgrind(name: &str, step: f64, steps: u64) -> Option<f64> {
    let program = std::env::current_exe().ok()?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(["--count", name, &step.to_string(), &steps.to_string()])
        .output()
        .ok()?;
    if !output.status.success() {
        return None;
    }
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(' ').next()?.trim().parse().ok()
}
