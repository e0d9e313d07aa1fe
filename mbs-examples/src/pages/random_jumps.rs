//! Random motions with forces that jump or bend.

use super::data::Data;
use super::markdown::{table as markdown, thousands};

const FILE: &str = "readme/random_jumps.csv";
/// Columns of the file; the first two identify a line.
pub const COLUMNS: [&str; 6] = ["mechanism", "way", "runs", "beyond", "median", "largest"];
/// How many of them identify a line.
pub const KEYS: usize = 2;
/// How motions are computed: by an accuracy, or by two-level steps of an order with a tolerance.
pub const WAYS: [&str; 4] = ["accuracy", "two-level 4", "two-level 6", "two-level 8"];

/// The errors by mechanism.
///
/// # Errors
/// Results that are missing.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let ways = WAYS.map(|way| format!("`{way}`"));
    let head: Vec<&str> = ["mechanism", "runs"]
        .into_iter()
        .chain(ways.iter().map(String::as_str))
        .collect();
    let rows: Result<Vec<Vec<String>>, String> = results
        .lines()
        .step_by(WAYS.len())
        .map(|first| {
            let mechanism = first.text("mechanism")?;
            let mut row = vec![mechanism.to_owned(), thousands(first.number("runs")?)];
            for way in WAYS {
                let line = results.find(&[("mechanism", mechanism), ("way", way)])?;
                let texts = ["beyond", "median", "largest"].map(|column| line.text(column));
                let [beyond, median, largest] = texts;
                row.push(format!("{}; {}, {}", beyond?, median?, largest?));
            }
            Ok(row)
        })
        .collect();
    Ok(format!(
        "{}\n\nFrom {}.",
        markdown(&head, &rows?),
        results.source()
    ))
}
