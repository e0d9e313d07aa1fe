//! The files of a recorded run.

use std::fmt;
use std::fs;
use std::io::{self, BufWriter};
use std::path::Path;

use super::csv::CsvWriter;
use super::frame_check::{check_columns, check_frames};
use super::motion::write_motion_of;
use super::npz::NpzWriter;
use super::path_error::about;
use super::{Frame, Recording};
use crate::Model;

/// The name of the table, …
pub(super) const TABLE: &str = "trajectory.csv";
/// … and of the same in binary form.
pub(super) const BINARY: &str = "trajectory.npz";
const MOTION: &str = "motion.html";
const PICTURES: [&str; 3] = ["outputs.svg", "energy.svg", "constraints.svg"];

/// What was saved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Saved {
    /// The number of instants in the table.
    pub instants: usize,
    /// The number of instants that `motion.html` shows.
    pub shown: usize,
}

/// In words: `20001 instants; motion.html shows 1251 of them`.
impl fmt::Display for Saved {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Saved { instants, shown } = self;
        write!(out, "{instants} instants; motion.html shows ")?;
        match shown < instants {
            true => write!(out, "{shown} of them"),
            false => write!(out, "all of them"),
        }
    }
}

impl Recording {
    /// Writes the instants as a table.
    ///
    /// # Errors
    /// Before anything is written, frames whose coordinates, velocities or outputs are not as many as those of the model
    /// ([`io::ErrorKind::InvalidData`]); `out` cannot be written.
    pub fn write_csv(&self, out: impl io::Write) -> io::Result<()> {
        check_columns(self.model, &self.frames)?;
        let mut table = CsvWriter::new(BufWriter::new(out), self.model)?;
        for frame in &self.frames {
            table.write(frame)?;
        }
        if let (Some(error), Some(last)) = (&self.stopped, self.frames.last()) {
            table.stopped(last.time, &error.to_string())?;
        }
        table.finish().map(|_| ())
    }

    /// Writes the columns of the same table to a binary file for NumPy and Julia ([`npz`](super::npz)).
    ///
    /// # Errors
    /// Before a file is made, frames as in [`Recording::write_csv`]; otherwise as [`NpzWriter::create`], [`NpzWriter::write`] and
    /// [`NpzWriter::finish`].
    pub fn write_npz(&self, path: impl AsRef<Path>) -> io::Result<()> {
        check_columns(self.model, &self.frames)?;
        let mut columns = NpzWriter::create(path, self.model)?;
        for frame in &self.frames {
            columns.write(frame)?;
        }
        columns.finish()
    }

    /// Writes the animation, one file for any browser; returns the number of instants that it shows.
    ///
    /// # Errors
    /// Before anything is written, frames that do not belong to the model, or whose time is not finite
    /// ([`io::ErrorKind::InvalidData`]); `out` cannot be written.
    pub fn write_motion(&self, out: impl io::Write) -> io::Result<usize> {
        self.write_motion_of(self.frames.len(), out)
    }

    fn write_motion_of(&self, recorded: usize, out: impl io::Write) -> io::Result<usize> {
        let stopped = self.stopped.as_ref().map(ToString::to_string);
        let (model, frames): (&Model, &[Frame]) = (self.model, &self.frames);
        let mut out = BufWriter::new(out);
        let (title, stopped) = (&self.title, stopped.as_deref());
        let shown = write_motion_of(recorded, &mut out, model, frames, title, stopped)?;
        io::Write::flush(&mut out)?;
        Ok(shown)
    }

    /// Writes `trajectory.csv` and `motion.html` into a folder, which is made if there is none; with the feature `plot`
    /// also `outputs.svg`, `energy.svg` and `constraints.svg`. Files of these names, and an earlier `trajectory.npz`, are
    /// replaced or removed.
    ///
    /// # Errors
    /// Before anything is written or removed, frames that do not belong to the model, or whose time is not finite
    /// ([`io::ErrorKind::InvalidData`]); a file that cannot be written, by its path.
    pub fn save(&self, folder: impl AsRef<Path>) -> io::Result<Saved> {
        check_frames(self.model, &self.frames)?;
        let folder = folder.as_ref();
        fs::create_dir_all(folder).map_err(|error| about(folder, &error))?;
        remove_earlier(folder);
        place(folder, TABLE, |file| self.write_csv(file))?;
        self.save_pictures(folder, self.frames.len())
    }

    /// Writes the animation and the diagrams of a run of which this number of instants was recorded.
    pub(super) fn save_pictures(&self, folder: &Path, instants: usize) -> io::Result<Saved> {
        let motion = |file| self.write_motion_of(instants, file);
        let shown = place(folder, MOTION, motion)?;
        #[cfg(feature = "plot")]
        for (name, picture) in PICTURES.into_iter().zip([
            super::plot::outputs(self),
            super::plot::energy(&self.title, &self.frames),
            super::plot::constraints(&self.title, &self.frames),
        ]) {
            let picture = picture.map_err(io::Error::other)?;
            place(folder, name, |mut file| {
                io::Write::write_all(&mut file, picture.as_bytes())
            })?;
        }
        Ok(Saved { instants, shown })
    }
}

/// Removes the files of an earlier run: what this one does not write must not look like its results.
pub(super) fn remove_earlier(folder: &Path) {
    for name in [TABLE, BINARY, MOTION].into_iter().chain(PICTURES) {
        // What cannot be removed is replaced, or is an error when it is written.
        let _ = fs::remove_file(folder.join(name));
    }
}

/// Makes a file of a folder.
fn place<T>(
    folder: &Path,
    name: &str,
    write: impl FnOnce(fs::File) -> io::Result<T>,
) -> io::Result<T> {
    let path = folder.join(name);
    let written = fs::File::create(&path).and_then(write);
    written.map_err(|error| about(&path, &error))
}
