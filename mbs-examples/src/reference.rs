//! Reference trajectories on disk, and the deviation of a run from them.

use std::path::{Path, PathBuf};

use mbs_runtime::Model;
use mbs_runtime::output::Frame;

use crate::scene::Reference;

/// Times closer than this part of the later one are the same instant.
const SAME_INSTANT: f64 = 1e-9;

/// The columns of a reference that a scene is compared with.
#[derive(Debug, Clone)]
pub struct ReferenceTable {
    /// The file it was read from.
    pub path: PathBuf,
    time: Vec<f64>,
    columns: Vec<Column>,
}

#[derive(Debug, Clone)]
struct Column {
    name: &'static str,
    /// Index into [`Model::outputs`].
    output: usize,
    values: Vec<f64>,
}

/// The deviation of a run from one column of its reference.
#[derive(Debug, Clone)]
pub struct Deviation {
    /// The column.
    pub column: &'static str,
    /// |output − reference| at the last instant of the run, if the reference has that instant.
    pub at_end: Option<f64>,
    /// The largest |output − reference| over the instants that run and reference share.
    pub largest: f64,
    /// How many instants they share.
    pub instants: usize,
}

impl ReferenceTable {
    /// Reads the reference of a scene; `None` if the file is not on this machine.
    ///
    /// # Errors
    /// The file exists, but cannot be used; the error is a message.
    pub fn find(reference: &Reference, model: &Model) -> Result<Option<Self>, String> {
        match directories()
            .map(|d| d.join(reference.file))
            .find(|p| p.is_file())
        {
            Some(path) => Self::read(path, reference, model).map(Some),
            None => Ok(None),
        }
    }

    /// Reads it from a file.
    ///
    /// # Errors
    /// As [`ReferenceTable::find`].
    pub fn read(path: PathBuf, reference: &Reference, model: &Model) -> Result<Self, String> {
        let shown = path.display();
        let text =
            std::fs::read_to_string(&path).map_err(|e| format!("cannot read {shown}: {e}"))?;
        let mut lines = text.lines();
        let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        let index = |name: &str| {
            let found = header.iter().position(|column| *column == name);
            found.ok_or_else(|| format!("{shown} has no column `{name}`"))
        };
        let time_index = index("time_s")?;
        let mut time = Vec::new();
        let mut columns = Vec::new();
        for &(output, name) in reference.columns {
            let position = model.outputs.iter().position(|q| q.name == output);
            let output = position.ok_or_else(|| {
                format!("the scene's reference names `{output}`, which is no output")
            })?;
            let values = Vec::new();
            columns.push((
                index(name)?,
                Column {
                    name,
                    output,
                    values,
                },
            ));
        }
        for (number, line) in lines
            .enumerate()
            .filter(|(_, line)| !line.trim().is_empty())
        {
            let cells: Vec<&str> = line.split(',').collect();
            let value = |index: usize| {
                let cell = cells
                    .get(index)
                    .and_then(|cell| cell.trim().parse::<f64>().ok());
                cell.ok_or_else(|| format!("{shown}, line {}: a number is missing", number + 2))
            };
            time.push(value(time_index)?);
            for (index, column) in &mut columns {
                column.values.push(value(*index)?);
            }
        }
        let columns = columns.into_iter().map(|(_, column)| column).collect();
        Ok(ReferenceTable {
            path,
            time,
            columns,
        })
    }

    /// The spacing of its first two instants, s.
    pub fn interval(&self) -> Option<f64> {
        match self.time.as_slice() {
            [first, second, ..] => Some(second - first),
            _ => None,
        }
    }

    /// Compares the recorded instants that the reference has too.
    pub fn compare(&self, frames: &[Frame]) -> Vec<Deviation> {
        let pairs: Vec<(usize, usize)> = frames
            .iter()
            .enumerate()
            .filter_map(|(frame, f)| Some((frame, self.row_at(f.time)?)))
            .collect();
        let deviation = |column: &Column| {
            let error = |&(frame, row): &(usize, usize)| {
                (frames[frame].outputs[column.output] - column.values[row]).abs()
            };
            let last = pairs.last().filter(|(frame, _)| frame + 1 == frames.len());
            Deviation {
                column: column.name,
                at_end: last.map(error),
                // `f64::max` would ignore a NaN.
                largest: pairs
                    .iter()
                    .map(error)
                    .fold(0.0, |most, e| if e > most || e.is_nan() { e } else { most }),
                instants: pairs.len(),
            }
        };
        self.columns.iter().map(deviation).collect()
    }

    /// The largest error of a column that is a position, m or rad, over the recorded instants; infinite where it is not a
    /// number.
    pub fn position_error(&self, frames: &[Frame]) -> f64 {
        let deviations = self.compare(frames);
        let position = |d: &&Deviation| d.column.ends_with("_m") || d.column.ends_with("_rad");
        let errors = deviations.iter().filter(position).map(|d| d.largest);
        errors.fold(0.0, |most, e| {
            if e.is_nan() {
                f64::INFINITY
            } else {
                most.max(e)
            }
        })
    }

    fn row_at(&self, time: f64) -> Option<usize> {
        let tolerance = SAME_INSTANT * time.abs().max(self.interval().unwrap_or(0.0));
        let row = self.time.partition_point(|t| *t < time - tolerance);
        (self.time.get(row)? - time)
            .abs()
            .le(&tolerance)
            .then_some(row)
    }
}

/// The folders that are searched for references: data of the crate, then a collection beside the repository.
fn directories() -> impl Iterator<Item = PathBuf> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    [
        package.join("reference"),
        package.join("../../shared/reference"),
    ]
    .into_iter()
}
