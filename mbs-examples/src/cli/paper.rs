//! `mbs paper`: the figures of the paper, with our code.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use mbs_examples::laboratory::paper::{
    ENSEMBLE_COLUMNS, ENSEMBLE_KEYS, Extent, Figure, RUN_COLUMNS, RUN_KEYS, SAMPLE_KEYS, Stores,
    draw, figures, measure, measure_ensemble,
};
use mbs_examples::laboratory::provenance::provenance;
use mbs_examples::laboratory::store::{Row, Store};

use super::failure::Failure;
use super::print::print;
use super::progress::Points;
use super::table::{Align, table};

const FIGURES: std::ops::RangeInclusive<u8> = 1..=7;

/// Arguments of `mbs paper`.
#[derive(Args)]
pub struct Paper {
    /// One figure, 1 to 7 [default: all].
    #[arg(long, value_name = "N")]
    figure: Option<String>,
    /// A twentieth of the simulated time.
    #[arg(long)]
    quick: bool,
    /// Directory for the files; runs that are there already are not taken again [default: out/paper].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Paper {
    /// Makes the runs that the files do not have yet, and draws.
    pub fn run(&self) -> Result<(), Failure> {
        let extent = match self.quick {
            true => Extent::QUICK,
            false => Extent::FULL,
        };
        let mut wanted = figures(extent);
        if let Some(number) = self.number()? {
            wanted.retain(|figure| figure.number == number);
        }
        let directory = self.out.clone().unwrap_or_else(|| "out/paper".into());
        fs::create_dir_all(&directory).map_err(|e| Failure::writing(&directory, e))?;
        let points: usize = wanted.iter().map(Figure::points).sum();
        let members = wanted.iter().map(|figure| figure.ensemble.len());
        let members = members.sum::<usize>() as u64 * u64::from(extent.members);
        let progress = Points::new("paper", points as u64 + members);
        let mut text = String::new();
        for figure in &wanted {
            let stores = self.take(figure, extent, &directory, &progress)?;
            text.push_str(&format!("Figure {}: {}\n", figure.number, figure.title));
            text.push_str(&summary(stores.runs.rows()));
            text.push('\n');
        }
        progress.finish();
        print(&format!("{text}written to {}\n", directory.display()))
    }

    fn number(&self) -> Result<Option<u8>, Failure> {
        let Some(text) = &self.figure else {
            return Ok(None);
        };
        match text.trim().parse() {
            Ok(number) if FIGURES.contains(&number) => Ok(Some(number)),
            _ => Err(Failure(format!(
                "--figure {text}: the figures are those of the mechanisms, --figure 1 to --figure 7"
            ))),
        }
    }

    /// The files of a figure.
    fn take(
        &self,
        figure: &Figure,
        extent: Extent,
        directory: &Path,
        progress: &Points,
    ) -> Result<Stores, Failure> {
        let form = if self.quick { "quick" } else { "full" };
        let note = |what: &str| format!("{}; {form}; {what}", provenance());
        let columns = figure.sample_columns();
        let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
        let path = directory.join(format!("figure-{}.csv", figure.number));
        let runs_path = directory.join(format!("figure-{}-runs.csv", figure.number));
        let open = |path: &Path, note: String, columns: &[&str], keys| {
            Store::open(path, &note, columns, keys).map_err(|e| Failure::writing(path, e))
        };
        let samples = note("what the curves show");
        let runs = note("how the runs ended; processor time with everything that is looked at");
        let mut stores = Stores {
            samples: open(&path, samples, &columns, SAMPLE_KEYS)?,
            runs: open(&runs_path, runs, &RUN_COLUMNS, RUN_KEYS)?,
        };
        measure(figure, extent, &mut stores, &mut |run| {
            progress.at(run);
            progress.tick();
        })
        .map_err(|e| Failure::writing(&path, e))?;
        if !figure.ensemble.is_empty() {
            let path = directory.join(format!("figure-{}-ensemble.csv", figure.number));
            let what = "runs from starts that differ by 1e-13 of the lengths";
            let mut ensemble = open(&path, note(what), &ENSEMBLE_COLUMNS, ENSEMBLE_KEYS)?;
            measure_ensemble(figure, extent, &mut ensemble, &mut |run| {
                progress.at(run);
                progress.tick();
            })
            .map_err(|e| Failure::writing(&path, e))?;
        }
        let picture = directory.join(format!("figure-{}.svg", figure.number));
        fs::write(&picture, draw(figure, &stores)).map_err(|e| Failure::writing(&picture, e))?;
        Ok(stores)
    }
}

/// The ends of the runs.
fn summary(rows: &[Row]) -> String {
    let heading = [
        ("run", Align::Left),
        ("outcome", Align::Left),
        ("reached, s", Align::Right),
        ("energy error, J", Align::Right),
        ("largest |φ|", Align::Right),
    ];
    let cells: Vec<_> = rows
        .iter()
        .map(|row| [0, 2, 3, 7, 9].map(|i| row[i].clone()))
        .collect();
    table(heading, &cells)
}
