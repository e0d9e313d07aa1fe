//! Numbers of calls of the accelerations in explicit steps.

use super::data::{Data, Line};
use super::markdown::{significant, table as markdown, thousands};
use super::rival::{BOUNDS, FILE, SCENES, best, first};

/// The calls of the rival and of `projected`.
pub fn table(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 6] = [
        "scene",
        "energy error, J",
        "calls of the rival (order, gain)",
        "calls of `projected` (order)",
        "ratio of the calls",
        "ratio of the times",
    ];
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for scene in SCENES {
        for bound in BOUNDS {
            let mut row = vec![first(scene, bound), bound.to_owned()];
            let rival = best(&results, scene, bound, "baumgarte")?;
            let projected = best(&results, scene, bound, "projected")?;
            match (rival, projected) {
                (Some(rival), Some(projected)) => row.extend(compare(rival, projected)?),
                _ => row.extend(["–", "–", "–", "–"].map(str::to_owned)),
            }
            rows.push(row);
        }
    }
    Ok(markdown(&HEADING, &rows))
}

fn compare(rival: Line, projected: Line) -> Result<[String; 4], String> {
    let ratio = |column| {
        let ratio = rival.number(column)? / projected.number(column)?;
        Ok::<_, String>(significant(ratio, 2))
    };
    Ok([
        format!(
            "{} ({}, {}/s)",
            thousands(rival.number("calls")?),
            rival.text("order")?,
            rival.text("gain_per_s")?
        ),
        format!(
            "{} ({})",
            thousands(projected.number("calls")?),
            projected.text("order")?
        ),
        ratio("calls")?,
        ratio("time_ms")?,
    ])
}
