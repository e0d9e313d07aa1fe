//! The tables beside the paper's figures.

use super::data::Data;
use super::markdown::{error, table as markdown};
use crate::laboratory::paper::{COMPARED, EXACT, ensemble_table, run_table};

/// The ends of the runs of a figure, with their settings.
fn runs(data: &Data, number: u8) -> Result<String, String> {
    let runs = data.table(&format!("paper/figure-{number}-runs.csv"))?;
    let samples = data.table(&format!("paper/figure-{number}.csv"))?;
    let compared = |run: &str| {
        let sample = samples.find(&[("run", run), ("time_s", COMPARED)]).ok()?;
        sample.text("energy_error_J").ok().map(str::to_owned)
    };
    let table = run_table(&runs.rows, &compared);
    Ok(format!("{table}\nMeasured at {}.\n", runs.source()))
}

/// The ends of the runs of its ensemble.
fn ensembles(data: &Data, number: u8) -> Result<String, String> {
    let members = data.table(&format!("paper/figure-{number}-ensemble.csv"))?;
    Ok(ensemble_table(&members.rows))
}

/// The largest deviations from the exact pendulum in the last ten seconds.
pub(super) fn deviations(data: &Data) -> Result<String, String> {
    const FROM: f64 = 990.0;
    let samples = data.table("paper/figure-1.csv")?;
    let runs = data.table("paper/figure-1-runs.csv")?;
    let own = ["own pivot.fx", "own pivot.fy"];
    let state = ["pivot.fx", "pivot.fy"];
    let mut rows = Vec::new();
    for run in runs.rows.iter().map(|row| row[0].as_str()) {
        let has_own = ["two-level", "alf3f-paper", "m-alf"].contains(&run);
        let columns = if has_own { own } else { state };
        let (mut height, mut force): (f64, f64) = (0.0, 0.0);
        let mut any = false;
        for line in samples.lines().filter(|l| l.text("run") == Ok(run)) {
            let time = line.number("time_s")?;
            if run == EXACT || time < FROM {
                continue;
            }
            let exact = samples.find(&[("run", EXACT), ("time_s", line.text("time_s")?)])?;
            any = true;
            height = height.max((line.number("y")? - exact.number("y")?).abs());
            for (column, of) in columns.iter().zip(state) {
                force = force.max((line.number(column)? - exact.number(of)?).abs());
            }
        }
        if any {
            rows.push(vec![format!("`{run}`"), error(height), error(force)]);
        }
    }
    Ok(markdown(&["run", "height, m", "reactions, N"], &rows))
}

/// The largest forces at the pin over the first ten seconds.
pub(super) fn peaks(data: &Data) -> Result<String, String> {
    const UNTIL: f64 = 10.0;
    const COLUMNS: [&str; 4] = [
        "own peak pin.fx",
        "own peak pin.fy",
        "step pin.fx",
        "step pin.fy",
    ];
    let samples = data.table("paper/figure-5.csv")?;
    let runs = data.table("paper/figure-5-runs.csv")?;
    let mut rows = Vec::new();
    for run in runs.rows.iter().map(|row| row[0].as_str()) {
        let mut peaks = [0.0_f64; 4];
        for line in samples.lines().filter(|l| l.text("run") == Ok(run)) {
            if line.number("time_s")? > UNTIL {
                continue;
            }
            for (peak, column) in peaks.iter_mut().zip(COLUMNS) {
                // The first sample is before the first step.
                *peak = peak.max(line.number(column).map_or(0.0, f64::abs));
            }
        }
        let mut row = vec![format!("`{run}`")];
        row.extend(peaks.map(|peak| format!("{peak:.1}")));
        rows.push(row);
    }
    let heading = [
        "largest over 10 s, N",
        "own, horizontal",
        "own, vertical",
        "of momentum, horizontal",
        "of momentum, vertical",
    ];
    Ok(markdown(&heading, &rows))
}

macro_rules! figures {
    ($($name:ident $of:ident $number:literal)*) => {
        $(
            pub(super) fn $name(data: &Data) -> Result<String, String> {
                $of(data, $number)
            }
        )*
    };
}

figures! {
    runs_1 runs 1
    runs_2 runs 2
    runs_3 runs 3
    runs_4 runs 4
    runs_5 runs 5
    runs_6 runs 6
    runs_7 runs 7
    ensembles_2 ensembles 2
    ensembles_3 ensembles 3
    ensembles_4 ensembles 4
    ensembles_6 ensembles 6
}
