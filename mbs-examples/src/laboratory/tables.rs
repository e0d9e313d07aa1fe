//! The charts as tables in Markdown, for the book: the fastest methods for an accuracy, and the failures.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::outcome::Outcome;
use super::stability::{Cell, Map};
use super::work_precision::Point;

/// Energy errors, J, for scenes that are shown in full, and for the others.
pub const FINE_BOUNDS: [i32; 9] = [-1, -2, -3, -4, -5, -6, -7, -8, -9];
/// For the others.
pub const COARSE_BOUNDS: [i32; 3] = [-2, -5, -8];

/// Families that are compared with the fastest.
const FAMILIES: [&str; 2] = ["two-level", "projected"];

/// The indices of the position error and of the energy error in [`Point::errors`].
pub const POSITION: usize = 0;
/// As [`POSITION`].
pub const ENERGY: usize = 1;

/// Methods with the time, s, that they need for an error of this measure, the fastest first.
pub fn ranking(points: &[Point], measure: usize, bound: f64) -> Vec<(&str, f64)> {
    let mut curves: BTreeMap<&str, Vec<&Point>> = BTreeMap::new();
    for point in points {
        curves.entry(&point.method).or_default().push(point);
    }
    let within = |point: &Point| point.outcome == Outcome::Ok && point.errors[measure] <= bound;
    let mut ranking = Vec::new();
    for (method, mut curve) in curves {
        curve.sort_by(|a, b| b.value.total_cmp(&a.value));
        // To exclude accidental results, the next finer step has to be within the bound, too.
        let kept = curve
            .windows(2)
            .filter(|pair| pair.iter().all(|p| within(p)));
        let least = kept.map(|pair| pair[0].cpu).min_by(f64::total_cmp);
        ranking.extend(least.map(|cpu| (method, cpu)));
    }
    ranking.sort_by(|a, b| a.1.total_cmp(&b.1));
    ranking
}

/// The fastest method for each energy error, and the fastest of each family.
pub fn front(points: &[Point], bounds: &[i32]) -> String {
    let mut out = String::from("| energy error ≤, J | fastest | ms |");
    for family in FAMILIES {
        let _ = write!(out, " best `{family}` | ms | ratio |");
    }
    out += "\n|---|---|---|---|---|---|---|---|---|\n";
    for &power in bounds {
        let ranking = ranking(points, ENERGY, 10_f64.powi(power));
        let Some(&(fastest, least)) = ranking.first() else {
            let _ = writeln!(out, "| 1e{power} | – | – | – | – | – | – | – | – |");
            continue;
        };
        let _ = write!(out, "| 1e{power} | `{fastest}` | {} |", short(1e3 * least));
        for family in FAMILIES {
            let best = ranking.iter().find(|(name, _)| name.starts_with(family));
            let _ = match best {
                Some((name, cpu)) => write!(
                    out,
                    " `{name}` | {} | {} |",
                    short(1e3 * cpu),
                    short(cpu / least)
                ),
                None => write!(out, " – | – | – |"),
            };
        }
        out.push('\n');
    }
    out
}

/// Numbers of failures of each method: lines of a table of scene, method and outcomes.
pub fn failures(scene: &str, points: &[Point], labels: &[&str]) -> String {
    let mut out = String::new();
    for &label in labels {
        let mut counts: BTreeMap<Outcome, usize> = BTreeMap::new();
        for point in points.iter().filter(|point| point.method == label) {
            if point.outcome.is_failure() {
                *counts.entry(point.outcome).or_default() += 1;
            }
        }
        let list: Vec<String> = counts
            .iter()
            .map(|(outcome, count)| format!("{count} × {}", outcome.name()))
            .collect();
        if !list.is_empty() {
            let _ = writeln!(out, "| `{scene}` | {label} | {} |", list.join(", "));
        }
    }
    out
}

/// Methods that do not apply to a scene, with any step or tolerance.
pub fn refused<'a>(points: &[Point], labels: &[&'a str]) -> Vec<&'a str> {
    let refuses = |label: &&&str| {
        let of_method = |point: &&Point| point.method == **label;
        let mut own = points.iter().filter(of_method).peekable();
        own.peek().is_some() && own.all(|point| point.outcome == Outcome::Refused)
    };
    labels.iter().filter(refuses).copied().collect()
}

/// Every failed cell of a map: method, outcome, whether every failed run of the cell stopped with an error of its own, and
/// columns (with the number of failed runs, if the cell has several).
pub fn failed_cells(map: &Map, cells: &[Cell]) -> String {
    let mut out = String::from("| method | outcome | stopped | columns |\n|---|---|---|---|\n");
    let mut any = false;
    for row in &map.rows {
        let mut groups: Vec<((Outcome, bool), Vec<String>)> = Vec::new();
        for cell in cells.iter().filter(|cell| cell.row == *row) {
            if !cell.outcome.is_failure() {
                continue;
            }
            let [runs, failed, _] = cell.runs;
            let text = match runs {
                1 => short(cell.column),
                _ => format!("{} ({failed}/{runs})", short(cell.column)),
            };
            let end = (cell.outcome, cell.is_stopped());
            match groups.iter_mut().find(|(known, _)| *known == end) {
                Some((_, list)) => list.push(text),
                None => groups.push((end, vec![text])),
            }
        }
        for ((outcome, stopped), columns) in groups {
            any = true;
            let _ = writeln!(
                out,
                "| {row} | {} | {} | {} |",
                outcome.name(),
                if stopped { "yes" } else { "no" },
                columns.join(", ")
            );
        }
    }
    if any {
        out
    } else {
        "No cell failed.\n".to_owned()
    }
}

/// Three significant digits, in the shortest form.
fn short(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return x.to_string();
    }
    let digits = 2 - x.abs().log10().floor() as i32;
    if !(-3..=6).contains(&digits) {
        let text = format!("{x:.2e}");
        return text.replace(".00e", "e").replace("0e", "e");
    }
    let text = format!("{x:.*}", digits.max(0) as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
