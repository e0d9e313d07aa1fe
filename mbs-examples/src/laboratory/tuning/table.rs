//! The search as a table in Markdown.

use std::fmt::Write as _;

use super::super::store::Row;
use super::score::Score;

/// Candidates of each method that are shown, the best first.
const SHOWN: usize = 4;

/// The best candidates of each method, from the rows of `tuning.csv`.
pub fn table(rows: &[Row]) -> String {
    let mut out = String::from(
        "| method | settings | completed | error | iterations in a unit | error · iterations², of the best |\n|---|---|---|---|---|---|\n",
    );
    let mut methods: Vec<&str> = rows
        .iter()
        .filter_map(|row| row.first())
        .map(|m| m.as_str())
        .collect();
    methods.dedup();
    for method in methods {
        let of_method = rows
            .iter()
            .filter(|row| row.first().is_some_and(|m| m == method));
        let mut scores: Vec<(&str, Score)> = of_method
            .filter_map(|row| Some((row.get(1)?.as_str(), Score::read(row)?)))
            .collect();
        scores.sort_by(|(_, a), (_, b)| {
            let merits = a.merit().total_cmp(&b.merit());
            b.completed.cmp(&a.completed).then(merits)
        });
        let best = scores.first().map_or(1.0, |(_, score)| score.merit());
        for (i, (settings, score)) in scores.iter().take(SHOWN).enumerate() {
            let name = if i == 0 {
                format!("`{method}`")
            } else {
                String::new()
            };
            let _ = writeln!(
                out,
                "| {name} | {settings} | {} of {} | {:.1e} | {:.0} | {:.2} |",
                score.completed,
                score.runs,
                score.error,
                score.work,
                score.merit() / best
            );
        }
    }
    out
}
