//! The table of the book's first page: the methods of this project beside other programs.

use super::data::{Data, Table};
use super::markdown::{significant, table as markdown};
use super::orders::RANDOM;
use super::rival::{BOUNDS, FILE, SCENES, best};

/// What was measured of other programs, below `book/src/results`.
const OTHERS: &str = "readme/others.csv";
/// Our own families.
const OWN: [&str; 2] = ["projected", "two-level"];

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
    let passages = data.table(RANDOM)?;
    for family in OWN {
        let mut row = vec![format!("mbs, `{family}`")];
        for scene in SCENES {
            let times = BOUNDS.map(|bound| match best(&own, scene, bound, family)? {
                Some(line) => Ok(significant(line.number("time_ms")?, 2)),
                None => Ok("–".to_owned()),
            });
            let times = times.into_iter().collect::<Result<Vec<_>, String>>()?;
            row.push(times.join(" / "));
        }
        row.push(lost(&passages, family)?);
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

/// The runs of order 8 that were lost, of those on the slider-crank and of those on the double four-bar.
fn lost(passages: &Table, family: &str) -> Result<String, String> {
    let mut all = 0.0;
    let counts = ["slider-crank", "double-four-bar"].map(|scene| {
        let line = passages.find(&[
            ("scene", scene),
            ("method", family),
            ("order", "8"),
            ("placement", "yes"),
        ])?;
        all = line.number("runs")?;
        Ok::<_, String>(line.number("failed")? + line.number("astray")?)
    });
    let [slider_crank, double_four_bar] = counts;
    Ok(format!("{} / {} of {all}", slider_crank?, double_four_bar?))
}
