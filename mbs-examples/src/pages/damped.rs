//! Methods for forces of velocity.

use super::data::Data;
use super::markdown::{significant, table as markdown};

const FILE: &str = "readme/damped.csv";

/// The processor time of each method, a row for each mechanism and bound of the error.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let (mut cells, mut methods) = (Vec::new(), Vec::new());
    for line in results.lines() {
        let cell = (line.text("mechanism")?, line.text("bound")?);
        let method = line.text("method")?;
        if !cells.contains(&cell) {
            cells.push(cell);
        }
        if !methods.contains(&method) {
            methods.push(method);
        }
    }
    let rows = cells.iter().map(|&(mechanism, bound)| {
        let mut row = vec![mechanism.to_owned(), bound.to_owned()];
        for method in &methods {
            let keys = [
                ("mechanism", mechanism),
                ("bound", bound),
                ("method", method),
            ];
            row.push(match results.find(&keys) {
                Ok(line) => significant(line.number("ms")?, 2),
                Err(_) => "–".to_owned(),
            });
        }
        Ok(row)
    });
    let rows: Result<Vec<Vec<String>>, String> = rows.collect();
    let titles: Vec<String> = methods
        .iter()
        .map(|method| format!("`{method}`, ms"))
        .collect();
    let titles = titles.iter().map(String::as_str);
    let titles: Vec<&str> = ["mechanism", "error"].into_iter().chain(titles).collect();
    let table = markdown(&titles, &rows?);
    Ok(format!("{table}\n\nMeasured at {}.\n", results.source()))
}
