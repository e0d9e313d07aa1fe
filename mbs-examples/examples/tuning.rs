//! Searches for the parameters of the baselines, and prints a table.
//!
//! `cargo run --release -p mbs-examples --example tuning [METHOD…]`; the store is `book/src/results/tuning.csv`, or the
//! file in the variable `TUNING_CSV`. Candidates that it has from the same commit are not run again.

use std::path::PathBuf;

use mbs_examples::laboratory::provenance::provenance;
use mbs_examples::laboratory::store::Store;
use mbs_examples::laboratory::tuning::{COLUMNS, KEYS, SUBJECTS, problems, search, table};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let path = std::env::var_os("TUNING_CSV").map_or_else(
        || PathBuf::from("book/src/results/tuning.csv"),
        PathBuf::from,
    );
    let note = format!(
        "{}; cargo run --release -p mbs-examples --example tuning",
        provenance()
    );
    let mut store = Store::open(&path, &note, &COLUMNS, KEYS)?;
    let problems = problems()?;
    for problem in &problems {
        eprintln!(
            "{}: unit {} s, {} s, size {:.2} m, {:.2} J, fine runs {:.0e} of it apart",
            problem.scene.name,
            problem.unit,
            problem.duration,
            problem.size,
            problem.energy,
            problem.agreement
        );
    }
    for subject in SUBJECTS {
        if !wanted.is_empty() && !wanted.iter().any(|name| subject.label.starts_with(name)) {
            continue;
        }
        let best = search(subject, &problems, &mut store, &mut |candidate, score| {
            eprintln!("{}: {}: {score:?}", subject.label, candidate.text());
        })?;
        eprintln!("{}: best {}", subject.label, best.text());
    }
    print!("{}", table(store.rows()));
    Ok(())
}
