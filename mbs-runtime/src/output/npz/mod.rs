//! A trajectory in binary form: the columns of the [table](super::csv), each an array of `f64` under its name, as an
//! `.npz` file.
//!
//! NumPy reads it by `numpy.load("trajectory.npz")["time_s"]`, Julia by `NPZ.npzread("trajectory.npz")["time_s"]`. Such a
//! file is a ZIP archive of `.npy` files without compression, which takes no library to write.

mod archive;
mod spill;

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use super::Frame;
use super::columns::Columns;
use super::path_error::about;
use crate::Model;
use archive::Archive;
use spill::Spill;

/// Writes frames as they come; memory does not grow with their number. A file beside the named one, with `.part` at its
/// end, holds them until [`NpzWriter::finish`].
#[derive(Debug)]
pub struct NpzWriter {
    path: PathBuf,
    columns: Columns,
    spill: Spill,
}

impl NpzWriter {
    /// Begins a file.
    ///
    /// # Errors
    /// A file that cannot be made, by its path.
    pub fn create(path: impl AsRef<Path>, model: &Model) -> io::Result<Self> {
        let path = path.as_ref().to_owned();
        let columns = Columns::of(model);
        let mut part = path.clone().into_os_string();
        part.push(".part");
        let spill = Spill::create(part.into(), columns.names.len())?;
        Ok(NpzWriter {
            path,
            columns,
            spill,
        })
    }

    /// Adds an instant.
    ///
    /// # Errors
    /// A file that cannot be written, by its path; more numbers than an archive holds, 4 GiB; coordinates, velocities or
    /// outputs that are not as many as those of the model ([`io::ErrorKind::InvalidData`]).
    pub fn write(&mut self, frame: &Frame) -> io::Result<()> {
        let rows = self.spill.rows() as u64 + 1;
        if !archive::holds(&self.columns.names, 8 * rows) {
            let text = "more than 4 GiB; record fewer instants, or read the table";
            return Err(about(&self.path, &io::Error::other(text)));
        }
        let values = self.columns.values(self.spill.rows(), frame)?;
        self.spill.push(values)
    }

    /// Writes the file.
    ///
    /// # Errors
    /// A file that cannot be written, by its path.
    pub fn finish(mut self) -> io::Result<()> {
        let written = self.write_columns();
        written.map_err(|error| about(&self.path, &error))
    }

    fn write_columns(&mut self) -> io::Result<()> {
        self.spill.finish()?;
        let mut archive = Archive::new(BufWriter::new(File::create(&self.path)?));
        let header = npy_header(self.spill.rows());
        for (index, name) in self.columns.names.iter().enumerate() {
            archive.begin(&format!("{name}.npy"))?;
            archive.write(&header)?;
            self.spill.read(index, |bytes| archive.write(bytes))?;
            archive.end()?;
        }
        archive.finish()
    }
}

/// The header of an array of so many `f64`: its length is a multiple of 64 bytes.
fn npy_header(rows: usize) -> Vec<u8> {
    let mut text = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows},), }}");
    let fixed = 10 + 1;
    text.push_str(&" ".repeat((fixed + text.len()).next_multiple_of(64) - fixed - text.len()));
    text.push('\n');
    let mut header = b"\x93NUMPY\x01\x00".to_vec();
    header.extend((text.len() as u16).to_le_bytes());
    header.extend(text.as_bytes());
    header
}
