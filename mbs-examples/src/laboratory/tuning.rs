//! The search for the parameters of the baselines, on scenes that are in no map and no figure. One parameter after the
//! other is varied over its grid, with the other parameters constant, and keeps its best value, until a round changes
//! nothing. `cargo run --release -p mbs-examples --example tuning` does it; the [`table`] is in the book.

mod candidates;
mod problems;
mod score;
mod table;

pub use candidates::{Candidate, SUBJECTS, Subject};
pub use problems::{Problem, problems};
pub use score::{Score, score};
pub use table::table;

use std::io;

use super::store::{Row, Store};

/// The columns of `tuning.csv`; the first two identify a candidate.
pub const COLUMNS: [&str; 9] = [
    "method",
    "settings",
    "runs",
    "completed",
    "wrong_branch",
    "stopped",
    "too_slow",
    "error",
    "iterations_per_unit",
];
/// How many of them identify a candidate.
pub const KEYS: usize = 2;
/// Rounds at most.
const ROUNDS: usize = 2;

/// Searches for the best parameters of a method; candidates that the store has are not run again. `tick` is called for
/// each candidate.
///
/// # Errors
/// A file that cannot be written.
pub fn search(
    subject: &'static Subject,
    problems: &[Problem],
    store: &mut Store,
    tick: &mut dyn FnMut(&Candidate, &Score),
) -> io::Result<Candidate> {
    let mut best = Candidate::start(subject);
    let mut best_score = known(&best, problems, store, tick)?;
    for _ in 0..ROUNDS {
        let before = best.clone();
        for parameter in 0..subject.parameters.len() {
            for &value in subject.parameters[parameter].1 {
                let candidate = best.with(parameter, value);
                let score = known(&candidate, problems, store, tick)?;
                if score.is_better(&best_score) {
                    (best, best_score) = (candidate, score);
                }
            }
        }
        if best == before {
            break;
        }
    }
    Ok(best)
}

fn known(
    candidate: &Candidate,
    problems: &[Problem],
    store: &mut Store,
    tick: &mut dyn FnMut(&Candidate, &Score),
) -> io::Result<Score> {
    let text = candidate.text();
    let key = [candidate.subject.label, &text];
    if let Some(score) = store.find(&key).and_then(Score::read) {
        return Ok(score);
    }
    let score = score(candidate, problems);
    let mut row: Row = key.map(str::to_owned).to_vec();
    row.extend(score.cells());
    store.put(row)?;
    tick(candidate, &score);
    Ok(score)
}
