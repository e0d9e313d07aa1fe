//! Random runs through singular poses.

use super::data::Data;
use super::markdown::{table as markdown_table, thousands};

const FILE: &str = "readme/random_passages.csv";

/// The outcomes by mechanism.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let heading = [
        "mechanism",
        "damped",
        "runs",
        "passed",
        "stopped",
        "on another branch",
        "energy wrong",
        "singular poses passed",
        "largest energy error",
    ];
    let counts = ["runs", "passed", "stopped", "astray", "energy", "poses"];
    let rows: Result<Vec<Vec<String>>, String> = results
        .lines()
        .map(|line| {
            let mut row = vec![
                line.text("mechanism")?.to_owned(),
                line.text("damped")?.to_owned(),
            ];
            for column in counts {
                row.push(thousands(line.number(column)?));
            }
            row.push(line.text("worst")?.to_owned());
            Ok(row)
        })
        .collect();
    Ok(format!(
        "{}\n\nFrom {}.",
        markdown_table(&heading, &rows?),
        results.source()
    ))
}
