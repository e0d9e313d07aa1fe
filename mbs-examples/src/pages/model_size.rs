//! One mechanism, modelled in four ways.

use super::data::Data;
use super::markdown::{significant, table as markdown};

const FILE: &str = "model-size.csv";

/// The table of `mbs chart model-size`.
pub fn table(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 7] = [
        "model",
        "velocities + rows (rank)",
        "operations",
        "method",
        "bound, m",
        "step, s",
        "time, ms",
    ];
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for line in results.lines() {
        let text = |column| line.text(column);
        rows.push(vec![
            text("model")?.to_owned(),
            format!(
                "{} + {} ({})",
                text("velocities")?,
                text("rows")?,
                text("rank")?
            ),
            text("operations")?.to_owned(),
            format!("`{}`", text("method")?),
            text("bound")?.to_owned(),
            short(line.number("step_s")?),
            short(1e3 * line.number("cpu_s")?),
        ]);
    }
    Ok(format!(
        "{}\n\nMeasured at {}.",
        markdown(&HEADING, &rows),
        results.source()
    ))
}

fn short(x: f64) -> String {
    if x < 1e-3 {
        format!("{x:.2e}")
    } else {
        significant(x, 3)
    }
}
