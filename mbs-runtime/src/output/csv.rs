//! A trajectory as a table: one row per frame, units in the header (`crank.b.x_dot_m_per_s`).

use std::fmt::Write as _;
use std::io::{self, Write};

use super::Frame;
use super::columns::Columns;
use crate::Model;

pub use super::columns::column;

/// Writes frames as they come, so that a run that stops leaves all rows up to there.
#[derive(Debug)]
pub struct CsvWriter<W: Write> {
    out: W,
    columns: Columns,
    rows: usize,
}

impl<W: Write> CsvWriter<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn new(mut out: W, model: &Model) -> io::Result<Self> {
        let columns = Columns::of(model);
        out.write_all((columns.names.join(",") + "\n").as_bytes())?;
        Ok(CsvWriter {
            out,
            columns,
            rows: 0,
        })
    }

    /// Writes one row, at once: behind a buffer, too, an interrupted run leaves whole rows. Every number reads back to the same bits.
    ///
    /// # Errors
    /// `out` cannot be written; coordinates, velocities or outputs that are not as many as those of the model
    /// ([`io::ErrorKind::InvalidData`]).
    pub fn write(&mut self, frame: &Frame) -> io::Result<()> {
        let mut row = String::new();
        let values = self.columns.values(self.rows, frame)?;
        for (index, value) in values.enumerate() {
            let separator = if index > 0 { "," } else { "" };
            // Writing to a string cannot fail.
            let _ = write!(row, "{separator}{value:?}");
        }
        row.push('\n');
        self.rows += 1;
        self.out.write_all(row.as_bytes())
    }

    /// Marks the table of a run that did not reach its end, with a last line `# stopped at t = …`.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn stopped(&mut self, time: f64, reason: &str) -> io::Result<()> {
        // A comment is one line.
        let reason = reason.split_whitespace().collect::<Vec<_>>().join(" ");
        self.out
            .write_all(format!("# stopped at t = {time:?} s: {reason}\n").as_bytes())
    }

    /// The writer.
    pub fn get_ref(&self) -> &W {
        &self.out
    }

    /// The writer, to take out what it holds.
    pub fn get_mut(&mut self) -> &mut W {
        &mut self.out
    }

    /// Writes what is still buffered and returns the writer.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}
