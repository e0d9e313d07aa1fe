//! Runs that are written while they last.

use std::fmt;
use std::fs;
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use super::csv::CsvWriter;
use super::npz::NpzWriter;
use super::path_error::about;
use super::save::{BINARY, Saved, TABLE, remove_earlier};
use super::thinned::Thinned;
use super::{Frame, Record};
use crate::{Model, SimulationError};

/// Why a run was not saved to its end.
#[derive(Debug)]
#[non_exhaustive]
pub enum SaveError {
    /// The run ended early; the files have all instants until then, and the reason.
    Simulation(SimulationError),
    /// A file that cannot be written, by its path.
    File(io::Error),
}

impl fmt::Display for SaveError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SaveError::Simulation(error) => fmt::Display::fmt(error, out),
            SaveError::File(error) => fmt::Display::fmt(error, out),
        }
    }
}

impl std::error::Error for SaveError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            SaveError::Simulation(error) => Some(error),
            SaveError::File(error) => Some(error),
        }
    }
}

impl From<SimulationError> for SaveError {
    fn from(error: SimulationError) -> Self {
        SaveError::Simulation(error)
    }
}

impl From<io::Error> for SaveError {
    fn from(error: io::Error) -> Self {
        SaveError::File(error)
    }
}

/// The tables of a run; errors have the path of the file.
struct Tables {
    path: PathBuf,
    csv: CsvWriter<BufWriter<fs::File>>,
    npz: Option<NpzWriter>,
}

impl Tables {
    fn create(folder: &Path, model: &Model, with_npz: bool) -> io::Result<Self> {
        let path = folder.join(TABLE);
        let csv = fs::File::create(&path);
        let csv = csv.and_then(|file| CsvWriter::new(BufWriter::new(file), model));
        let csv = csv.map_err(|error| about(&path, &error))?;
        let npz = match with_npz {
            true => Some(NpzWriter::create(folder.join(BINARY), model)?),
            false => None,
        };
        Ok(Tables { path, csv, npz })
    }

    fn write(&mut self, frame: &Frame) -> io::Result<()> {
        let written = self.csv.write(frame);
        written.map_err(|error| about(&self.path, &error))?;
        self.npz.as_mut().map_or(Ok(()), |npz| npz.write(frame))
    }

    /// Marks the table of a run that did not reach its end.
    fn stopped(&mut self, time: f64, error: &SimulationError) -> io::Result<()> {
        let marked = self.csv.stopped(time, &error.to_string());
        marked.map_err(|error| about(&self.path, &error))
    }

    fn finish(self) -> io::Result<()> {
        let Tables { path, csv, npz } = self;
        csv.finish().map_err(|error| about(&path, &error))?;
        npz.map_or(Ok(()), NpzWriter::finish)
    }
}

impl Record<'_> {
    /// [`Record::save`] also writes `trajectory.npz`: the columns of the table for NumPy and Julia ([`npz`](super::npz)).
    pub fn npz(mut self) -> Self {
        self.with_npz = true;
        self
    }

    /// Runs, and writes the files of [`Recording::save`](super::Recording::save): each instant goes to the table when it
    /// is there, and only so many are kept as animation and diagrams show. So a run of any length takes the same memory.
    ///
    /// # Errors
    /// A file that cannot be written; otherwise as [`Record::run`], after the files until then have been written.
    pub fn save(mut self, folder: impl AsRef<Path>) -> Result<Saved, SaveError> {
        // An earlier result stays where this cannot be run.
        self.check()?;
        let folder = folder.as_ref();
        fs::create_dir_all(folder).map_err(|error| about(folder, &error))?;
        let model = self.simulation.model();
        remove_earlier(folder);
        let mut tables = Tables::create(folder, model, self.with_npz)?;
        let mut thinned = Thinned::new();
        let ended = self.advance(&mut |frame| {
            tables.write(&frame)?;
            thinned.push(frame);
            Ok::<(), SaveError>(())
        });
        let stopped = match ended {
            Ok(()) => None,
            Err(SaveError::Simulation(error)) => Some(error),
            Err(error) => return Err(error),
        };
        let now = self.simulation.time();
        if let Some(error) = &stopped {
            if thinned.time().is_none_or(|last| last < now) {
                let frame = Frame::record(self.simulation);
                tables.write(&frame)?;
                thinned.push(frame);
            }
            tables.stopped(now, error)?;
        }
        tables.finish()?;
        let instants = thinned.count();
        let recording = self.recording(thinned.finish(), stopped.as_ref());
        let saved = recording.save_pictures(folder, instants)?;
        stopped.map_or(Ok(saved), |error| Err(error.into()))
    }
}
