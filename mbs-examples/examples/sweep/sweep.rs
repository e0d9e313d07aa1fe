//! Random runs of mechanisms, with a summary.

use crate::case::Case;
use crate::entries::{Entry, entries};
use crate::table::Count;
use crate::trial::{End, Trial, name};
use crate::trusted::Trusted;
use std::collections::BTreeMap;

/// The counts of a mechanism, by the label of the method.
pub type Counts = BTreeMap<&'static str, Count>;

/// The names of methods in which no run may be lost.
const OURS: [&str; 2] = ["two-level", "projected"];

/// Runs mechanisms by the arguments COUNT, SEED, NAME and RUN; `keep` gets the rows of the table.
///
/// # Errors
/// An argument that is no number, a file that cannot be written, or runs that are lost or panicked.
pub fn run(
    mut cases: Vec<Case>,
    arguments: &[String],
    keep: &mut dyn FnMut(Vec<String>) -> Result<(), String>,
) -> Result<(), String> {
    let number = |index: usize| match arguments.get(index) {
        Some(text) => match text.parse::<usize>() {
            Ok(number) => Ok(Some(number)),
            Err(_) => Err(format!("`{text}` is no number")),
        },
        None => Ok(None),
    };
    let (count, seed) = (number(0)?.unwrap_or(1000), number(1)?.unwrap_or(1) as u64);
    let only = number(3)?;
    if let Some(name) = arguments.get(2) {
        cases.retain(|case| case.name == *name);
        if cases.is_empty() {
            return Err(format!("there is no mechanism `{name}` here"));
        }
    }
    std::panic::set_hook(Box::new(|_| {}));
    let each = count.div_ceil(cases.len().max(1));
    let mut methods = Counts::new();
    for case in &cases {
        let counts = match sweep(case, each, seed, only) {
            Ok(counts) => counts,
            Err(message) => {
                println!("\n{message}");
                continue;
            }
        };
        for (label, count) in counts {
            let mut row = vec![case.name.clone(), label.to_owned()];
            row.extend(count.cells());
            keep(row)?;
            methods.entry(label).or_default().join(&count);
        }
    }
    println!("\nall mechanisms");
    let mut wrong = 0;
    for entry in entries() {
        let Some(count) = methods.get(entry.label) else {
            continue;
        };
        println!("  {:24}{count}", entry.label);
        let ours = OURS.iter().any(|name| entry.label.starts_with(name));
        wrong += count.panics + if ours { count.lost } else { 0 };
    }
    match wrong {
        0 => Ok(()),
        wrong => Err(format!("{wrong} runs are lost without a word, or panicked")),
    }
}

/// Runs a mechanism `count` times, or its run of the given number only, and prints what is wrong.
///
/// # Errors
/// A message: its motion is not known.
pub fn sweep(case: &Case, count: usize, seed: u64, only: Option<usize>) -> Result<Counts, String> {
    let trusted = Trusted::new(case)?;
    let known = trusted.doubt.len();
    println!(
        "\n{}: known to {:.3} s from {}, doubt {:.0e}",
        case.name,
        trusted.instants[known - 1],
        trusted.source,
        trusted.doubt[known - 1]
    );
    let accepts = |entry: &Entry| {
        let settings = entry.settings(case.step, 1e-4, true);
        case.start(settings).map(|_| ())
    };
    let (mut accepted, mut refused) = (Vec::new(), Vec::new());
    for entry in entries() {
        match accepts(&entry) {
            Ok(()) => accepted.push(entry),
            Err(error) => refused.push(format!("{} ({})", entry.label, name(&error))),
        }
    }
    if !refused.is_empty() {
        println!("does not accept {}", refused.join(", "));
    }
    let mut counts = Counts::new();
    for number in 0..count {
        if only.is_some_and(|only| only != number) {
            continue;
        }
        let trial = Trial::draw(case, &trusted, &accepted, seed, number);
        if only.is_some() {
            println!("{trial}");
        }
        let end = trial.run(case, &trusted, 1.0);
        let expected = trial.lost(case, &trusted, &end);
        if only.is_some() {
            println!("    {end:?} of {:.1e} J", trusted.energy);
            for part in [1.1, 1.05, 0.95, 0.9, 0.8, 0.64, 0.5, 0.25, 0.125] {
                println!("    {part}: {:?}", trial.run(case, &trusted, part));
            }
        }
        if let Some(expected) = expected {
            println!(
                "lost: {trial}: {end:?} of {:.1e} J, expected {expected:.1e}",
                trusted.energy
            );
        }
        if let End::Panic(text) = &end {
            println!("panic: {trial}: {text}");
        }
        let counted = counts.entry(trial.entry.label).or_default();
        counted.add(&trial, &end, expected.is_some());
    }
    for entry in entries() {
        if let Some(count) = counts.get(entry.label) {
            println!("  {:24}{count}", entry.label);
        }
    }
    Ok(counts)
}
