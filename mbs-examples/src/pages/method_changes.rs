//! Runs with an accuracy of motions that change their character.

use super::data::Data;
use super::markdown::{significant, table as markdown};

const FILE: &str = "readme/method_changes.csv";
/// Columns of the file; the first two identify a run.
pub const COLUMNS: [&str; 8] = [
    "mechanism",
    "accuracy",
    "methods",
    "error_over_accuracy",
    "time_ms",
    "projected_ms",
    "radau_ms",
    "two_level_ms",
];
/// How many of them identify a run.
pub const KEYS: usize = 2;

/// The methods, and the times beside those of each method alone.
///
/// # Errors
/// Results that are missing.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for line in results.lines() {
        rows.push(vec![
            line.text("mechanism")?.to_owned(),
            line.text("accuracy")?.to_owned(),
            line.text("methods")?.to_owned(),
            significant(line.number("error_over_accuracy")?, 2),
            significant(line.number("time_ms")?, 2),
            significant(line.number("projected_ms")?, 2),
            of_radau(line.text("radau_ms")?),
            significant(line.number("two_level_ms")?, 2),
        ]);
    }
    let head = [
        "mechanism",
        "accuracy",
        "methods",
        "error / accuracy",
        "run, ms",
        "projected 8 alone",
        "radau alone",
        "two-level alone",
    ];
    Ok(markdown(&head, &rows))
}

/// It is no candidate of every mechanism.
fn of_radau(time: &str) -> String {
    time.parse()
        .map_or("–".to_owned(), |time| significant(time, 2))
}
