//! What rustc compiles for a mechanism.

use super::data::Data;
use super::markdown::{table as markdown_table, thousands};

const FILE: &str = "readme/compile.csv";

/// Sizes and times as mechanisms grow.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let heading = [
        "mechanism",
        "size",
        "velocities",
        "rows",
        "operations",
        "written out",
        "lines",
        "release, s",
        "dev, s",
    ];
    let counts = ["velocities", "rows", "operations", "written", "lines"];
    let rows: Result<Vec<Vec<String>>, String> = results
        .lines()
        .map(|line| {
            let mut row = vec![
                line.text("mechanism")?.to_owned(),
                line.text("size")?.to_owned(),
            ];
            for column in counts {
                row.push(thousands(line.number(column)?));
            }
            for column in ["release_s", "dev_s"] {
                row.push(line.text(column)?.to_owned());
            }
            Ok(row)
        })
        .collect();
    Ok(format!(
        "{}\n\nFrom {}.",
        markdown_table(&heading, &rows?),
        results.source()
    ))
}
