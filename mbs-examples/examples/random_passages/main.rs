//! Random runs through singular poses: phases, speeds, steps, orders, tolerances, whole runs and pieces, damped and
//! undamped. A run fails if it stops, if it ends on another branch of the motion, or if its energy balance is wrong.
//!
//! `cargo run --release -p mbs-examples --example random_passages -- [COUNT] [SEED] [NAME RUN] [--csv book/src/results/readme]`

#[allow(dead_code)] // For tests, too.
#[path = "../../../tests/src/random.rs"]
mod random;
mod run;

use mbs_examples::pages::record::Recorder;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::passages::SCENES;
use run::{End, Run};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

const COLUMNS: [&str; 9] = [
    "mechanism",
    "damped",
    "runs",
    "passed",
    "stopped",
    "astray",
    "energy",
    "poses",
    "worst",
];

/// The counts of a row.
#[derive(Default)]
struct Count {
    runs: usize,
    passed: usize,
    stopped: usize,
    astray: usize,
    energy: usize,
    /// Singular poses passed.
    poses: usize,
    /// The largest error of energy of runs that passed.
    worst: f64,
}

fn main() -> Result<(), String> {
    let mut recorder =
        Recorder::new("cargo run --release -p mbs-examples --example random_passages")?;
    let (count, seed) = (recorder.number(0, 1000)?, recorder.number(1, 1)?);
    if let [_, _, name, run] = &recorder.arguments[..] {
        let found = SCENES.iter().find(|scene| scene.name == name);
        let scene = found.ok_or_else(|| format!("no mechanism `{name}`"))?;
        let run = Run::draw(scene, seed, run.parse().map_err(|_| "RUN is a number")?);
        println!("{run:?}\n{:?}", run.execute(scene));
        return Ok(());
    }
    let next = AtomicUsize::new(0);
    let counts: Vec<Mutex<Count>> = (0..2 * SCENES.len()).map(|_| Mutex::default()).collect();
    let work = || {
        loop {
            let job = next.fetch_add(1, Ordering::Relaxed);
            if job >= count {
                return;
            }
            judge(&counts, seed, job);
        }
    };
    std::thread::scope(|scope| {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        for _ in 0..cores {
            scope.spawn(work);
        }
    });
    let mut file = recorder.file("random_passages.csv", &COLUMNS, 2)?;
    println!(
        "{:<26} {:>7} {:>6} {:>7} {:>8} {:>7} {:>7} {:>8} {:>9}",
        "mechanism", "damped", "runs", "passed", "stopped", "branch", "energy", "poses", "worst"
    );
    let mut failures = 0;
    for (row, count) in counts.into_iter().enumerate() {
        let count = count.into_inner().map_err(|error| error.to_string())?;
        let (name, damped) = (SCENES[row / 2].name, ["no", "yes"][row % 2]);
        let numbers = [
            count.runs,
            count.passed,
            count.stopped,
            count.astray,
            count.energy,
            count.poses,
        ];
        let [runs, passed, stopped, astray, energy, poses] = numbers;
        println!(
            "{name:<26} {damped:>7} {runs:>6} {passed:>7} {stopped:>8} {astray:>7} {energy:>7} {poses:>8} {:>9.1e}",
            count.worst
        );
        let mut line = vec![name.to_owned(), damped.to_owned()];
        line.extend(numbers.map(|number| number.to_string()));
        line.push(format!("{:.1e}", count.worst));
        file.put(line)?;
        failures += runs - passed;
    }
    match failures {
        0 => Ok(()),
        _ => Err(format!("{failures} runs failed")),
    }
}

fn judge(counts: &[Mutex<Count>], seed: usize, job: usize) {
    let (place, number) = (job % SCENES.len(), job / SCENES.len());
    let scene: &Scene = SCENES[place];
    let run = Run::draw(scene, seed, number);
    let end = run.execute(scene);
    let row = 2 * place + usize::from(run.is_damped());
    let mut count = counts[row]
        .lock()
        .unwrap_or_else(|error| error.into_inner());
    count.runs += 1;
    match end {
        End::Passed { energy, poses } => {
            count.passed += 1;
            count.poses += poses;
            count.worst = count.worst.max(energy);
            return;
        }
        End::Stopped(_) => count.stopped += 1,
        End::Astray(_) => count.astray += 1,
        End::Energy(_) => count.energy += 1,
    }
    println!("{} {number}: {end:?}, {run:?}", scene.name);
}
