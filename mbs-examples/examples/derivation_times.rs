//! The time to compile each scene from its declaration to Rust, stage by stage.
//!
//! Procedural macros run unoptimised in users' builds, so run this unoptimised, too:
//! `cargo run --profile unoptimised -p mbs-examples --example derivation_times [-- --csv book/src/results/readme]`

use mbs_examples::pages::record::Recorder;
use mbs_macros_core::{analyse, dag, emit};
use std::time::{Duration, Instant};

fn main() -> Result<(), String> {
    const COLUMNS: [&str; 6] = [
        "scene",
        "analyse_ms",
        "lower_ms",
        "emit_ms",
        "total_ms",
        "operations",
    ];
    let recorder = Recorder::new(
        "cargo run --profile unoptimised -p mbs-examples --example derivation_times",
    )?;
    recorder.check_names([])?;
    let mut file = recorder.file("derivation.csv", &COLUMNS, 1)?;
    println!(
        "{:<22} {:>12} {:>10} {:>10} {:>10} {:>12}",
        "scene", "analyse", "lower", "emit", "total", "operations"
    );
    for scene in mbs_examples::scenes::scenes() {
        let best = (0..3)
            .filter_map(|_| compile(scene.model.declaration))
            .min_by_key(|times| times.total());
        if let Some(times) = &best {
            let stages = [times.analyse, times.lower, times.emit, times.total()];
            let mut row = vec![scene.name.to_owned()];
            row.extend(stages.map(|stage| format!("{:.2}", milliseconds(stage))));
            row.push(times.operations.to_string());
            file.put(row)?;
        }
        match best {
            Some(times) => println!(
                "{:<22} {:>9.1} ms {:>7.1} ms {:>7.1} ms {:>7.1} ms {:>12}",
                scene.name,
                milliseconds(times.analyse),
                milliseconds(times.lower),
                milliseconds(times.emit),
                milliseconds(times.total()),
                times.operations
            ),
            None => println!("{:<22} does not compile from its own text", scene.name),
        }
    }
    Ok(())
}

struct Times {
    analyse: Duration,
    lower: Duration,
    emit: Duration,
    operations: usize,
}

impl Times {
    fn total(&self) -> Duration {
        self.analyse + self.lower + self.emit
    }
}

fn compile(declaration: &str) -> Option<Times> {
    let tokens = declaration.parse().ok()?;
    let start = Instant::now();
    let (declaration, analysis) = analyse(tokens);
    let (declaration, analysis) = (declaration?, analysis.ok()?);
    let analyse = start.elapsed();
    let start = Instant::now();
    let program = dag::lower(&analysis.derived);
    let lower = start.elapsed();
    let operations = program
        .functions
        .iter()
        .map(|function| function.cost().total())
        .sum();
    let start = Instant::now();
    let text = emit::mechanism(&declaration, &analysis, &program).to_string();
    let emit = start.elapsed();
    (!text.is_empty()).then_some(Times {
        analyse,
        lower,
        emit,
        operations,
    })
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
