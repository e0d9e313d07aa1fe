//! Random motions with forces that jump or bend.

use super::data::Data;
use super::markdown::{table as markdown, thousands};

const FILE: &str = "readme/random_jumps.csv";
/// Columns of the file.
pub const COLUMNS: [&str; 6] = [
    "mechanism",
    "method",
    "errors",
    "beyond",
    "median",
    "largest",
];
/// How many of them identify a line.
pub const KEYS: usize = 2;
/// Names of the ways to compute a motion, and the order of those with two-level steps and a tolerance.
pub const METHODS: [(&str, Option<u8>); 4] = [
    ("accuracy", None),
    ("two-level 4", Some(4)),
    ("two-level 6", Some(6)),
    ("two-level 8", Some(8)),
];

/// The errors by mechanism.
///
/// # Errors
/// Results that are missing.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let methods = METHODS.map(|(method, _)| format!("`{method}`"));
    let head: Vec<&str> = ["mechanism", "errors"]
        .into_iter()
        .chain(methods.iter().map(String::as_str))
        .collect();
    let rows: Result<Vec<Vec<String>>, String> = results
        .lines()
        .filter(|line| line.text("method") == Ok(METHODS[0].0))
        .map(|first| {
            let mechanism = first.text("mechanism")?;
            let mut row = vec![mechanism.to_owned(), thousands(first.number("errors")?)];
            for (method, _) in METHODS {
                let line = results.find(&[("mechanism", mechanism), ("method", method)])?;
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
