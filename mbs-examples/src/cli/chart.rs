//! `mbs chart`: the method laboratory.

mod model_size;
mod stability;
mod work_precision;

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use mbs_examples::laboratory::provenance::provenance;
use mbs_examples::laboratory::store::Store;

use super::failure::Failure;

/// Arguments of `mbs chart`.
#[derive(Args)]
pub struct Chart {
    /// Which chart.
    #[arg(value_enum)]
    kind: Kind,
    /// Scenes, or maps of the chart of stability [default: all that the chart is for].
    scenes: Vec<String>,
    /// Fewer points: two minutes instead of half an hour.
    #[arg(long)]
    quick: bool,
    /// Directory for the files; points that its CSV holds already are not measured again [default: out/chart].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    /// Processor time against errors of position, energy and reactions, for all methods.
    WorkPrecision,
    /// Where methods fail, and how.
    Stability,
    /// One mechanism modelled in four ways.
    ModelSize,
}

impl Chart {
    /// Measures the points that the file does not have yet, and draws.
    pub fn run(&self) -> Result<(), Failure> {
        let directory = self.out.clone().unwrap_or_else(|| "out/chart".into());
        fs::create_dir_all(&directory).map_err(|e| Failure::writing(&directory, e))?;
        match self.kind {
            Kind::WorkPrecision => work_precision::run(self, &directory),
            Kind::Stability => stability::run(self, &directory),
            Kind::ModelSize => model_size::run(self, &directory),
        }
    }

    /// Opens the file of a chart; `settings` is the description of its numbers.
    fn store(
        &self,
        path: &Path,
        settings: &str,
        columns: &[&str],
        keys: usize,
    ) -> Result<(Store, String), Failure> {
        let extent = if self.quick { "quick" } else { "full" };
        let note = format!("{}; {extent}; {settings}", provenance());
        let store = Store::open(path, &note, columns, keys);
        store
            .map(|store| (store, note))
            .map_err(|e| Failure::writing(path, e))
    }
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|e| Failure::writing(path, e))
}
