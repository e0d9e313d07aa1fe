//! Random motions with forces that jump or bend.

use super::data::Data;
use super::markdown::{table as markdown, thousands};

const FILE: &str = "readme/random_jumps.csv";
/// Columns of the file; the first identifies a line.
pub const COLUMNS: [&str; 5] = ["mechanism", "runs", "beyond", "median", "largest"];
/// How many of them identify a line.
pub const KEYS: usize = 1;

/// The errors by mechanism.
///
/// # Errors
/// Results that are missing.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let head = [
        "mechanism",
        "runs",
        "above 10 accuracies",
        "median error, accuracies",
        "largest",
    ];
    let rows: Result<Vec<Vec<String>>, String> = results
        .lines()
        .map(|line| {
            Ok(vec![
                line.text("mechanism")?.to_owned(),
                thousands(line.number("runs")?),
                thousands(line.number("beyond")?),
                line.text("median")?.to_owned(),
                line.text("largest")?.to_owned(),
            ])
        })
        .collect();
    Ok(format!(
        "{}\n\nFrom {}.",
        markdown(&head, &rows?),
        results.source()
    ))
}
