//! Rows on their way to columns: blocks of rows in a file, each of them column by column.

use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::PathBuf;

use crate::output::path_error::about;

/// Numbers of a block, 4 MB.
const BLOCK: usize = 1 << 19;

/// The file; removed with this value.
#[derive(Debug)]
pub(super) struct Spill {
    path: PathBuf,
    file: File,
    columns: usize,
    /// Rows of a whole block.
    most: usize,
    /// The rows of the present block.
    block: Vec<f64>,
    bytes: Vec<u8>,
    rows: usize,
}

impl Spill {
    pub(super) fn create(path: PathBuf, columns: usize) -> io::Result<Self> {
        let mut options = File::options();
        let options = options.read(true).write(true).create(true).truncate(true);
        let file = options.open(&path).map_err(|error| about(&path, &error))?;
        Ok(Spill {
            path,
            file,
            columns,
            most: (BLOCK / columns.max(1)).max(1),
            block: Vec::new(),
            bytes: Vec::new(),
            rows: 0,
        })
    }

    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    pub(super) fn push(&mut self, row: impl Iterator<Item = f64>) -> io::Result<()> {
        self.block.extend(row);
        self.rows += 1;
        match self.rows.is_multiple_of(self.most) {
            true => self.finish(),
            false => Ok(()),
        }
    }

    /// Writes the present block.
    pub(super) fn finish(&mut self) -> io::Result<()> {
        self.bytes.clear();
        for column in 0..self.columns {
            for row in self.block.chunks_exact(self.columns) {
                self.bytes.extend(row[column].to_le_bytes());
            }
        }
        self.block.clear();
        let written = self.file.write_all(&self.bytes);
        written.map_err(|error| about(&self.path, &error))
    }

    /// Hands on a column in parts, after [`Self::finish`].
    pub(super) fn read(
        &mut self,
        column: usize,
        mut take: impl FnMut(&[u8]) -> io::Result<()>,
    ) -> io::Result<()> {
        for first in (0..self.rows).step_by(self.most) {
            let length = self.most.min(self.rows - first);
            let start = 8 * (first * self.columns + column * length);
            self.file.seek(SeekFrom::Start(start as u64))?;
            self.bytes.resize(8 * length, 0);
            self.file.read_exact(&mut self.bytes)?;
            take(&self.bytes)?;
        }
        Ok(())
    }
}

impl Drop for Spill {
    fn drop(&mut self) {
        // What remains of it does no harm.
        let _ = fs::remove_file(&self.path);
    }
}
