//! Random runs of every scene, compared in position.

use std::collections::BTreeMap;

use super::data::{Data, Line};
use super::markdown::{paragraph, table as markdown, thousands};

/// Below `book/src/results`.
const FILE: &str = "readme/sweep.csv";
/// Counts of the file.
const COUNTS: [&str; 6] = ["runs", "ok", "stopped", "lost", "lost_unplaced", "panics"];
/// The methods in which no run may be lost, as the labels begin; the others are those of the literature.
const OURS: [&str; 2] = ["two-level", "projected"];

/// Sums of the counts, and the errors by name.
#[derive(Default)]
struct Sum {
    counts: [f64; COUNTS.len()],
    errors: BTreeMap<String, usize>,
}

impl Sum {
    fn add(&mut self, line: &Line) -> Result<(), String> {
        for (sum, column) in self.counts.iter_mut().zip(COUNTS) {
            *sum += line.number(column)?;
        }
        for error in line.text("errors")?.split("; ") {
            if let Some((name, count)) = error.split_once(' ') {
                let count = count.parse::<usize>();
                let count = count.map_err(|_| format!("{FILE}: `{error}` is no error"))?;
                *self.errors.entry(name.to_owned()).or_default() += count;
            }
        }
        Ok(())
    }

    fn cells(&self) -> impl Iterator<Item = String> {
        self.counts.iter().map(|count| thousands(*count))
    }
}

/// All runs by method.
pub fn by_method(data: &Data) -> Result<String, String> {
    let table = data.table(FILE)?;
    let mut methods: Vec<(&str, Sum)> = Vec::new();
    for line in table.lines() {
        let name = line.text("method")?;
        let index = match methods.iter().position(|(method, _)| *method == name) {
            Some(index) => index,
            None => {
                methods.push((name, Sum::default()));
                methods.len() - 1
            }
        };
        methods[index].1.add(&line)?;
    }
    let ours = |name: &str| OURS.iter().position(|begin| name.starts_with(begin));
    methods.sort_by_key(|(name, _)| (ours(name).unwrap_or(OURS.len()), name.to_string()));
    let rows: Vec<Vec<String>> = methods.iter().map(row).collect();
    let heading = [
        "method",
        "runs",
        "`Ok`",
        "stopped",
        "lost",
        "lost, not placed",
        "panics",
        "errors by name",
    ];
    Ok(markdown(&heading, &rows))
}

fn row((name, sum): &(&str, Sum)) -> Vec<String> {
    let errors = sum.errors.iter();
    let errors: Vec<String> = errors
        .map(|(name, count)| format!("`{name}` {count}"))
        .collect();
    let mut row = vec![format!("`{name}`")];
    row.extend(sum.cells());
    row.push(errors.join(", "));
    row
}

/// The runs of the two-level and the projected method by scene, and of the others.
pub fn by_scene(data: &Data) -> Result<String, String> {
    let table = data.table(FILE)?;
    let mut scenes: Vec<(&str, [Sum; 3])> = Vec::new();
    for line in table.lines() {
        let (scene, method) = (line.text("scene")?, line.text("method")?);
        if scenes.last().is_none_or(|(last, _)| *last != scene) {
            scenes.push((scene, Default::default()));
        }
        let family = OURS.iter().position(|begin| method.starts_with(begin));
        if let Some((_, sums)) = scenes.last_mut() {
            sums[family.unwrap_or(OURS.len())].add(&line)?;
        }
    }
    let rows = scenes.iter().map(|(scene, sums)| {
        let mut row = vec![format!("`{scene}`")];
        for sum in sums {
            let [runs, _, stopped, lost, unplaced, _] = sum.counts;
            row.push(format!("{runs} / {stopped} / {lost} / {unplaced}"));
        }
        row
    });
    let heading = ["scene", "`two-level`", "`projected`", "other methods"];
    Ok(markdown(&heading, &rows.collect::<Vec<_>>()))
}

/// The number of runs, and what was lost of our methods.
pub fn sentence(data: &Data) -> Result<String, String> {
    let table = data.table(FILE)?;
    let (mut all, mut ours) = (Sum::default(), Sum::default());
    for line in table.lines() {
        all.add(&line)?;
        let method = line.text("method")?;
        if OURS.iter().any(|begin| method.starts_with(begin)) {
            ours.add(&line)?;
        }
    }
    let [runs, .., panics] = all.counts;
    let [.., lost, unplaced, _] = ours.counts;
    Ok(paragraph(&format!(
        "Of {} runs {} panicked. Of {} runs with `two-level` and `projected` {} with placement and {} without it are lost without a \
         word.",
        thousands(runs),
        thousands(panics),
        thousands(ours.counts[0]),
        thousands(lost),
        thousands(unplaced),
    )))
}
