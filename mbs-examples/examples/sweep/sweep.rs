//! Random runs of mechanisms.

use crate::case::Case;
use crate::entries::{Entry, entries};
use crate::table::Count;
use crate::trial::{End, Trial, name};
use crate::trusted::Trusted;
use std::collections::BTreeMap;

/// The counts of a mechanism, by the label of the method.
pub type Counts = BTreeMap<&'static str, Count>;

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
        let settings = entry.settings(case.model, case.step, 1e-4, true);
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
        let end = trial.run(case, &trusted, 1.0);
        let expected = trial.lost(case, &trusted, &end);
        if only.is_some() {
            println!("{trial}: {end:?} of {:.1e} J", trusted.energy);
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
