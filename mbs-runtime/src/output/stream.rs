//! Runs that are written while they last.

use std::fmt;
use std::fs;
use std::io::{self, BufWriter};
use std::path::Path;

use super::csv::CsvWriter;
use super::npz::NpzWriter;
use super::path_error::about;
use super::save::{BINARY, Saved, TABLE, remove_earlier};
use super::thinned::Thinned;
use super::{Frame, Record};
use crate::SimulationError;

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

/// The tables of a run.
struct Tables {
    csv: CsvWriter<BufWriter<fs::File>>,
    npz: Option<NpzWriter>,
}

impl Tables {
    fn write(&mut self, frame: &Frame) -> io::Result<()> {
        self.csv.write(frame)?;
        self.npz.as_mut().map_or(Ok(()), |npz| npz.write(frame))
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
        let path = folder.join(TABLE);
        let in_table = |error: io::Error| about(&path, &error);
        let csv =
            fs::File::create(&path).and_then(|file| CsvWriter::new(BufWriter::new(file), model));
        let npz = match self.with_npz {
            true => Some(NpzWriter::create(folder.join(BINARY), model)?),
            false => None,
        };
        let mut tables = Tables {
            csv: csv.map_err(in_table)?,
            npz,
        };
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
            let marked = tables.csv.stopped(now, &error.to_string());
            marked.map_err(in_table)?;
        }
        tables.csv.finish().map_err(in_table)?;
        if let Some(npz) = tables.npz {
            npz.finish()?;
        }
        let instants = thinned.count();
        let recording = self.recording(thinned.finish(), stopped.as_ref());
        let saved = recording.save_pictures(folder, instants)?;
        stopped.map_or(Ok(saved), |error| Err(error.into()))
    }
}
