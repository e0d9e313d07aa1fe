//! Passages with random steps from random phases.

use super::data::{Data, Line};
use super::markdown::{about, error, paragraph, significant, table as markdown};

/// Below `book/src/results`.
pub const FILE: &str = "readme/phases.csv";
/// Columns of the file; the first four identify a sweep.
pub const COLUMNS: [&str; 16] = [
    "scene",
    "order",
    "placement",
    "tolerance",
    "runs",
    "failed",
    "astray",
    "energy_error_median_J",
    "energy_error_worst_J",
    "position_error_median_m",
    "position_error_worst_m",
    "ratio_median",
    "ratio_90",
    "ratio_99",
    "ratio_largest",
    "within_3_percent",
];
/// How many of them identify a sweep.
pub const KEYS: usize = 4;
const SCENES: [&str; 2] = ["slider-crank", "double-four-bar"];

/// Two digits, of large numbers with a power of ten.
fn ratio(x: f64) -> String {
    if x < 1e3 { format!("{x:.1}") } else { error(x) }
}

/// The table of sweeps, and what it says.
pub fn table(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 7] = [
        "scene, order",
        "placed",
        "failed, wrong branch",
        "energy error, J: median, worst",
        "worst position error, m",
        "ratio: 99 %, largest",
        "ratio ≤ 3",
    ];
    let results = data.table(FILE)?;
    let sweep = |scene, order, placement, tolerance| {
        results.find(&[
            ("scene", scene),
            ("order", order),
            ("placement", placement),
            ("tolerance", tolerance),
        ])
    };
    let mut rows = Vec::new();
    for scene in SCENES {
        for placement in ["no", "yes"] {
            for order in ["2", "8"] {
                let line = sweep(scene, order, placement, "1e-13")?;
                rows.push(row(line)?);
            }
        }
    }
    let [slider, four, finer] = [
        sweep(SCENES[0], "8", "yes", "1e-13")?,
        sweep(SCENES[1], "8", "yes", "1e-13")?,
        sweep(SCENES[1], "8", "yes", "1e-15")?,
    ];
    let says = |line: Line, column| line.number(column);
    Ok(format!(
        "{}\n\n{}",
        markdown(&HEADING, &rows),
        paragraph(&format!(
            "At eighth order with placement the largest energy error of the double four-bar is {} J, that of the slider-crank, with its \
             longest steps, {} J. On the double four-bar {} % of these values of h have a ratio above 3, {} at most. The errors \
             are about {} J there. With the constraint tolerance of 1e-13 of the size a stage sometimes needs no correction; its \
             residual times forces of 100 N is 1e-11 J. With a tolerance of 1e-15 (`--example passage_phases 500 \
             double-four-bar 1e-15`) {} % of the ratios are 3 at most, and the largest is {}.",
            about(says(four, "energy_error_worst_J")?),
            about(says(slider, "energy_error_worst_J")?),
            significant(100.0 - says(four, "within_3_percent")?, 2),
            ratio(says(four, "ratio_largest")?),
            about(says(four, "energy_error_median_J")?),
            says(finer, "within_3_percent")?,
            ratio(says(finer, "ratio_largest")?),
        ))
    ))
}

fn row(line: Line) -> Result<Vec<String>, String> {
    let number = |column| line.number(column);
    Ok(vec![
        format!("{}, {}", line.text("scene")?, line.text("order")?),
        line.text("placement")?.to_owned(),
        format!("{}, {}", line.text("failed")?, line.text("astray")?),
        format!(
            "{}, {}",
            error(number("energy_error_median_J")?),
            error(number("energy_error_worst_J")?)
        ),
        error(number("position_error_worst_m")?),
        format!(
            "{}, {}",
            ratio(number("ratio_99")?),
            ratio(number("ratio_largest")?)
        ),
        format!("{:.1} %", number("within_3_percent")?),
    ])
}
