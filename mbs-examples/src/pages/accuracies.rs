//! Runs with an accuracy instead of a method.

use super::data::Data;
use super::markdown::{significant, table as markdown};

/// Below `book/src/results`.
pub const FILE: &str = "readme/accuracies.csv";
/// Columns of the file; the first two identify a run.
pub const COLUMNS: [&str; 8] = [
    "scene",
    "accuracy",
    "chosen",
    "error_over_accuracy",
    "time_ms",
    "start_ms",
    "fastest",
    "fastest_ms",
];
/// How many of them identify a run.
pub const KEYS: usize = 2;

/// What was chosen, its error, and its time against the fastest.
///
/// # Errors
/// Results that are missing.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for line in results.lines() {
        let (time, fastest) = (line.number("time_ms")?, line.number("fastest_ms")?);
        rows.push(vec![
            line.text("scene")?.to_owned(),
            line.text("accuracy")?.to_owned(),
            line.text("chosen")?.to_owned(),
            significant(line.number("error_over_accuracy")?, 2),
            significant(time, 2),
            significant(line.number("start_ms")?, 2),
            line.text("fastest")?.to_owned(),
            significant(time / fastest, 2),
        ]);
    }
    let head = [
        "scene",
        "accuracy",
        "chosen",
        "error / accuracy",
        "run, ms",
        "choice, ms",
        "fastest for this error",
        "ratio",
    ];
    Ok(markdown(&head, &rows))
}
