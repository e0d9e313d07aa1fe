//! Explicit Runge–Kutta steps compared with two-level steps: times at the best settings, and these settings.

use super::data::{Data, Line, Table};
use super::markdown::{significant, table as markdown};

/// Below `book/src/results`.
pub const FILE: &str = "readme/rival.csv";
/// Columns of the file; the first three identify a row. The other cells are empty if no run of a family stays within
/// the bound.
pub const COLUMNS: [&str; 9] = [
    "scene",
    "bound_J",
    "family",
    "order",
    "gain_per_s",
    "tolerance",
    "steps",
    "calls",
    "time_ms",
];
/// How many of them identify a row.
pub const KEYS: usize = 3;
/// The families, ours first.
pub const FAMILIES: [&str; 3] = ["two-level", "projected", "baumgarte"];
/// Bounds of max |E − E₀|, J, as they are in the file.
pub const BOUNDS: [&str; 3] = ["1e-1", "1e-3", "1e-6"];
pub(super) const SCENES: [&str; 3] = ["slider-crank", "double-four-bar", "bricard"];

pub(super) fn best<'t>(
    results: &'t Table,
    scene: &str,
    bound: &str,
    family: &str,
) -> Result<Option<Line<'t>>, String> {
    let line = results.find(&[("scene", scene), ("bound_J", bound), ("family", family)])?;
    Ok((!line.text("order")?.is_empty()).then_some(line))
}

/// The README's table of times.
pub fn table(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 4] = [
        "scene",
        "two-level",
        "projected",
        "Runge–Kutta with Baumgarte's terms, best of orders and gains",
    ];
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for scene in SCENES {
        let mut row = vec![format!("`{scene}`")];
        for family in FAMILIES {
            let times = BOUNDS.map(|bound| match best(&results, scene, bound, family)? {
                Some(line) => Ok(significant(line.number("time_ms")?, 3)),
                None => Ok("–".to_owned()),
            });
            row.push(
                times
                    .into_iter()
                    .collect::<Result<Vec<_>, String>>()?
                    .join(" / "),
            );
        }
        rows.push(row);
    }
    Ok(format!(
        "{}\n\nMeasured at {}.",
        markdown(&HEADING, &rows),
        results.source()
    ))
}

/// The settings behind these times.
pub fn settings(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 5] = [
        "scene",
        "energy error, J",
        "two-level: order, steps",
        "projected: order, steps",
        "Baumgarte's terms: order, gain, steps",
    ];
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for scene in SCENES {
        for bound in BOUNDS {
            let mut row = vec![first(scene, bound), bound.to_owned()];
            for family in FAMILIES {
                row.push(match best(&results, scene, bound, family)? {
                    None => "–".to_owned(),
                    Some(line) => match line.text("gain_per_s")? {
                        "" => format!("{}, {}", line.text("order")?, line.text("steps")?),
                        gain => {
                            format!("{}, {gain}/s, {}", line.text("order")?, line.text("steps")?)
                        }
                    },
                });
            }
            rows.push(row);
        }
    }
    Ok(markdown(&HEADING, &rows))
}

/// The name of the scene in the first of its rows.
pub(super) fn first(scene: &str, bound: &str) -> String {
    match bound == BOUNDS[0] {
        true => format!("`{scene}`"),
        false => String::new(),
    }
}
