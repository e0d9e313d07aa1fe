//! How well rows hold, and the corrections that it takes.

use super::data::{Data, Table};
use super::markdown::{error, paragraph, significant};
use super::scene_runs::FILE;

/// Scenes that are this many times worse than the middle one are named.
const WORSE: f64 = 1e3;

/// The largest |φ| and |A v + b| of the runs of the table.
pub fn measured(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    Ok(paragraph(&format!(
        "Over the {} runs of the table with rows the largest |φ| is {}, and the largest |A v + b| {}.",
        holding(&results, "holonomic_error")?.len(),
        extremes(&results, "holonomic_error")?,
        extremes(&results, "velocity_error")?,
    )))
}

/// `5.8e-9 (`four-bar-40`)`, and if that is far from the others `…; without … at most …`.
fn extremes(results: &Table, column: &str) -> Result<String, String> {
    let mut values = holding(results, column)?;
    values.sort_by(|a, b| b.1.total_cmp(&a.1));
    let middle = values.get(values.len() / 2).map_or(0.0, |value| value.1);
    let far: Vec<_> = values
        .iter()
        .filter(|value| value.1 > WORSE * middle)
        .collect();
    let list = |values: &[&(&str, f64)]| {
        let texts = values
            .iter()
            .map(|(name, value)| format!("{} (`{name}`)", error(*value)));
        texts.collect::<Vec<_>>().join(" and ")
    };
    let rest = values.get(far.len()).ok_or("no scene has rows")?;
    Ok(match far.is_empty() {
        true => list(&[rest]),
        false => format!("{}, elsewhere {}", list(&far), list(&[rest])),
    })
}

/// The scenes with rows, and a column of theirs.
fn holding<'t>(results: &'t Table, column: &str) -> Result<Vec<(&'t str, f64)>, String> {
    let mut values = Vec::new();
    for line in results.lines() {
        if line.number("rows")? > 0.0 {
            values.push((line.text("scene")?, line.number(column)?));
        }
    }
    Ok(values)
}

/// Corrections of κ₁ a step.
pub fn corrections(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let line = results.find(&[("scene", "double-four-bar")])?;
    let count = line.number("iterations")? / line.number("stages")?;
    Ok(significant(count, 2))
}
