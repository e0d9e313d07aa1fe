//! Runs with an accuracy instead of a method.

use super::data::Data;
use super::markdown::{paragraph, significant, table as markdown};

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
/// A run should take no longer than this multiple of the fastest setting's time.
const WANTED: f64 = 1.5;

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

/// The largest error of all runs.
///
/// # Errors
/// Results that are missing.
pub fn largest_error(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let mut errors = results
        .lines()
        .map(|line| line.number("error_over_accuracy"));
    let most = errors.try_fold(0.0, |most: f64, error| Ok::<_, String>(most.max(error?)))?;
    Ok(paragraph(&format!(
        "In the table of [all scenes](results/accuracy.md#accuracies) the largest error is {} times the accuracy that was asked for.",
        significant(most, 2)
    )))
}

/// How many runs take about the time of the fastest setting, and which do not.
///
/// # Errors
/// Results that are missing.
pub fn ratios(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let (mut most, mut within, mut slower) = (0.0_f64, 0, Vec::new());
    for line in results.lines() {
        let ratio = line.number("time_ms")? / line.number("fastest_ms")?;
        if ratio <= WANTED {
            (most, within) = (most.max(ratio), within + 1);
        } else {
            let (scene, accuracy) = (line.text("scene")?, line.text("accuracy")?);
            slower.push(format!(
                "`{scene}` at {accuracy} ({})",
                significant(ratio, 2)
            ));
        }
    }
    let others = match slower.as_slice() {
        [] => String::new(),
        slower => format!("; it is larger on {}", slower.join(", ")),
    };
    Ok(paragraph(&format!(
        "The ratio is at most {} in {within} of {} cells{others}.",
        significant(most, 3),
        within + slower.len()
    )))
}
