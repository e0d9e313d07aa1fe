//! The tables beside the figures: the ends of the runs with their settings, and the spread of an ensemble of starts.

use std::fmt::Write as _;

use super::figure1::EXACT;
use crate::laboratory::outcome::Outcome;
use crate::laboratory::store::Row;

/// The instant at which runs are compared, s, in the form of the files.
pub const COMPARED: &str = "20";
/// Places in a row of [`RUN_COLUMNS`](super::RUN_COLUMNS).
const SETTINGS: usize = 1;
const OUTCOME: usize = 2;
const REACHED: usize = 3;
const REJECTED: usize = 6;
const AT_END: usize = 7;
const LARGEST: usize = 8;
const PHI: usize = 9;
const RATE: usize = 10;
const BRANCH: usize = 11;

/// The ends of the runs of a figure; `compared` gives the energy error of a run after [`COMPARED`]. A run that stops does so within a
/// nominal step, so that the error at its end may be larger than that of every whole step.
pub fn run_table(runs: &[Row], compared: &dyn Fn(&str) -> Option<String>) -> String {
    let mut out = String::from(
        "| run | settings | reached, s | energy error at 20 s, J | the same at the end, J | largest at the end of a whole step, J | largest \\|φ\\| | largest \\|ψ̇\\| | rejected |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for row in runs.iter().filter(|row| row[0] != EXACT) {
        let compared = compared(&row[0]).map_or(String::new(), |cell| short(&cell));
        let mut reached = row[REACHED].clone();
        if row[OUTCOME] != Outcome::Ok.name() {
            reached = format!("{reached}, {}", row[OUTCOME]);
        }
        if row[BRANCH].parse::<f64>().is_ok_and(|branch| branch > 0.1) {
            reached += ", other branch";
        }
        let _ = writeln!(
            out,
            "| `{}` | {} | {reached} | {compared} | {} | {} | {} | {} | {} |",
            row[0],
            row[SETTINGS],
            short(&row[AT_END]),
            short(&row[LARGEST]),
            short(&row[PHI]),
            short(&row[RATE]),
            row[REJECTED],
        );
    }
    out
}

/// The ends of the runs of each ensemble.
pub fn ensemble_table(rows: &[Row]) -> String {
    let mut out = String::from(
        "| run | starts that reach the end | the first that stops, s | energy errors, J | on another branch |\n\
         |---|---|---|---|---|\n",
    );
    let mut labels: Vec<&str> = Vec::new();
    for row in rows {
        if !labels.contains(&row[0].as_str()) {
            labels.push(&row[0]);
        }
    }
    for label in labels {
        let members: Vec<&Row> = rows.iter().filter(|row| row[0] == label).collect();
        let number = |row: &Row, i: usize| row[i].parse::<f64>().unwrap_or(f64::NAN);
        let passed = members.iter().filter(|r| r[2] == Outcome::Ok.name());
        let stopped = members.iter().filter(|r| r[2] != Outcome::Ok.name());
        let first = stopped.map(|r| number(r, 3)).fold(f64::INFINITY, f64::min);
        let errors = members.iter().map(|r| number(r, 5));
        let [low, high] = errors.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
            [low.min(x), high.max(x)]
        });
        let astray = members.iter().filter(|r| number(r, 6) > 0.1).count();
        let first = if first.is_finite() {
            format!("{first:.3}")
        } else {
            String::new()
        };
        let _ = writeln!(
            out,
            "| `{label}` | {} of {} | {first} | {low:.1e} to {high:.1e} | {astray} |",
            passed.count(),
            members.len(),
        );
    }
    out
}

/// Two digits.
fn short(cell: &str) -> String {
    match cell.parse::<f64>() {
        Ok(value) => format!("{value:.1e}"),
        Err(_) => cell.to_owned(),
    }
}
