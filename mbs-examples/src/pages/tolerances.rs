//! Errors of runs with a tolerance.

use mbs_runtime::Settings;

use super::data::Data;
use super::markdown::{paragraph, significant, table as markdown, thousands};

/// Below `book/src/results`.
pub const FILE: &str = "readme/tolerances.csv";
/// Columns of the file; the first three identify a run.
pub const COLUMNS: [&str; 6] = [
    "scene",
    "order",
    "tolerance",
    "error_over_tolerance",
    "stages",
    "stages_with_looks",
];
/// How many of them identify a run.
pub const KEYS: usize = 3;
const SCENES: [&str; 8] = [
    "pendulum",
    "slider-crank",
    "double-four-bar",
    "andrews",
    "bricard",
    "chaplygin-sleigh",
    "heavy-top",
    "flyball-governor",
];
const TOLERANCES: [&str; 7] = ["1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9"];

/// The order of [`Settings::for_tolerance`].
fn usual_order(tolerance: &str) -> Result<String, String> {
    let tolerance = tolerance.parse().map_err(|_| "a tolerance is no number")?;
    Ok(Settings::for_tolerance(tolerance).order.to_string())
}

/// The error as a multiple of the tolerance, and stages.
pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for scene in SCENES {
        let mut row = vec![scene.to_owned()];
        for tolerance in TOLERANCES {
            let order = usual_order(tolerance)?;
            let found = results.find(&[
                ("scene", scene),
                ("order", &order),
                ("tolerance", tolerance),
            ]);
            row.push(match found {
                Ok(line) => {
                    let ratio = line.number("error_over_tolerance")?;
                    format!("{ratio:.2} ({})", line.text("stages")?)
                }
                Err(_) => "–".to_owned(),
            });
        }
        rows.push(row);
    }
    Ok(markdown(&[&["scene"], &TOLERANCES[..]].concat(), &rows))
}

/// The largest multiples at other orders than the usual ones.
pub fn others(data: &Data) -> Result<String, String> {
    const SHOWN: usize = 3;
    let results = data.table(FILE)?;
    let mut found = Vec::new();
    for line in results.lines() {
        let [scene, order, tolerance] = [
            line.text("scene")?,
            line.text("order")?,
            line.text("tolerance")?,
        ];
        if order != "2" && usual_order(tolerance)? != order {
            found.push((
                line.number("error_over_tolerance")?,
                scene,
                order,
                tolerance,
            ));
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    let list: Vec<String> = (found.iter().take(SHOWN))
        .map(|(ratio, scene, order, tolerance)| {
            format!(
                "{} at {tolerance} (order {order} on {scene})",
                significant(*ratio, 2)
            )
        })
        .collect();
    Ok(paragraph(&format!(
        "Other orders above 2 have larger multiples on some scenes: the largest are {}.",
        list.join(", ")
    )))
}

/// The cost of instants between steps.
pub fn looks(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let order = usual_order("1e-6")?;
    let keys = [
        ("scene", "slider-crank"),
        ("order", order.as_str()),
        ("tolerance", "1e-6"),
    ];
    let line = results.find(&keys)?;
    Ok(paragraph(&format!(
        "The stages of these shorter steps are counted, too: `mbs simulate slider-crank --tolerance 1e-6` shows 1001 instants \
         and takes {} stages, of which {} belong to whole steps.",
        thousands(line.number("stages_with_looks")?),
        thousands(line.number("stages")?),
    )))
}
