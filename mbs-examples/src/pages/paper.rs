//! The tables beside the paper's figures.

use super::data::Data;
use crate::laboratory::paper::{COMPARED, ensemble_table, run_table};

/// How the runs of a figure ended, with their settings.
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

/// How the starts of its ensembles ended.
fn ensembles(data: &Data, number: u8) -> Result<String, String> {
    let members = data.table(&format!("paper/figure-{number}-ensemble.csv"))?;
    Ok(ensemble_table(&members.rows))
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
