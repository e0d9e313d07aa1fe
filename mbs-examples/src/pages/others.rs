//! The table of the book's first page: the methods of this project beside other programs.

use super::data::Data;
use super::markdown::{significant, table as markdown};
use super::rival::{BOUNDS, FILE, SCENES, best};

/// What was measured of other programs, below `book/src/results`.
const OTHERS: &str = "readme/others.csv";
/// Our own families, with the runs of order 8 that were lost.
const OWN: [(&str, &str); 2] = [
    ("projected", "not measured / 0 of 100"),
    ("two-level", "0 / 0 of 100"),
];

/// Milliseconds for each mechanism and bound, and lost runs.
pub fn table(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 5] = [
        "",
        "slider-crank",
        "double four-bar",
        "Bricard",
        "runs lost",
    ];
    let own = data.table(FILE)?;
    let mut rows = Vec::new();
    for (family, lost) in OWN {
        let mut row = vec![format!("mbs, `{family}`")];
        for scene in SCENES {
            let times = BOUNDS.map(|bound| match best(&own, scene, bound, family)? {
                Some(line) => Ok(significant(line.number("time_ms")?, 2)),
                None => Ok("–".to_owned()),
            });
            let times = times.into_iter().collect::<Result<Vec<_>, String>>()?;
            row.push(times.join(" / "));
        }
        row.push(lost.to_owned());
        rows.push(row);
    }
    for line in data.table(OTHERS)?.lines() {
        let columns = [
            "program",
            "slider_crank_ms",
            "double_four_bar_ms",
            "bricard_ms",
            "lost_runs",
        ];
        let cells = columns.map(|column| line.text(column).map(str::to_owned));
        rows.push(cells.into_iter().collect::<Result<Vec<_>, String>>()?);
    }
    Ok(format!(
        "{}\n\nThe rows of mbs: {}.",
        markdown(&HEADING, &rows),
        own.source()
    ))
}
