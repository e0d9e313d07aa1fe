//! A CSV file with one row for each measured point, from which an interrupted measurement continues.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A point as text. The first cells identify it.
pub type Row = Vec<String>;

/// The file.
pub struct Store {
    path: PathBuf,
    head: String,
    columns: usize,
    keys: usize,
    rows: Vec<Row>,
    file: File,
}

impl Store {
    /// Opens the file for rows of these columns, the first `keys` of which identify a point. Existing rows are kept if
    /// the note above them is the same (machine, commit and settings); otherwise the file is written anew, and the old one is
    /// kept beside it as `NAME.csv.old`, or with a number behind.
    ///
    /// # Errors
    /// A file that cannot be read or written.
    pub fn open(path: &Path, note: &str, columns: &[&str], keys: usize) -> io::Result<Self> {
        let head = format!("# {note}\n{}\n", columns.join(","));
        let text = match fs::read_to_string(path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(error),
        };
        let others = text.lines().nth(2).is_some() && !text.starts_with(&head);
        if others {
            let names = (1..).map(|number| match number {
                1 => path.with_extension("csv.old"),
                number => path.with_extension(format!("csv.old{number}")),
            });
            for name in names.take(1000) {
                if !name.exists() {
                    fs::rename(path, name)?;
                    break;
                }
            }
        }
        let mut store = Store {
            path: path.to_owned(),
            columns: columns.len(),
            keys,
            rows: Vec::new(),
            file: OpenOptions::new().append(true).create(true).open(path)?,
            head,
        };
        if let Some(body) = text.strip_prefix(&store.head) {
            // Text after the last end of line is incomplete: the measurement was interrupted there.
            for line in body.split_inclusive('\n').filter(|l| l.ends_with('\n')) {
                let row: Row = line.trim_end().split(',').map(str::to_owned).collect();
                if row.len() == store.columns {
                    store.replace(row);
                }
            }
        }
        store.compact()?;
        Ok(store)
    }

    /// The rows, in the order in which their points came first.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The row of a point.
    pub fn find(&self, key: &[&str]) -> Option<&Row> {
        self.rows.iter().find(|row| row[..self.keys] == *key)
    }

    /// Stores a row and replaces an earlier one of the same point. It is on disk when this returns.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn put(&mut self, row: Row) -> io::Result<()> {
        let row: Row = row.iter().map(|cell| clean(cell)).collect();
        debug_assert_eq!(row.len(), self.columns);
        self.file.write_all(line(&row).as_bytes())?;
        self.replace(row);
        Ok(())
    }

    /// Writes each point once.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn compact(&mut self) -> io::Result<()> {
        let text: String = self.rows.iter().map(line).collect();
        let beside = self.path.with_extension("csv.part");
        fs::write(&beside, format!("{}{text}", self.head))?;
        fs::rename(&beside, &self.path)?;
        self.file = OpenOptions::new().append(true).open(&self.path)?;
        Ok(())
    }

    fn replace(&mut self, row: Row) {
        let keys = self.keys;
        match self.rows.iter_mut().find(|r| r[..keys] == row[..keys]) {
            Some(place) => *place = row,
            None => self.rows.push(row),
        }
    }
}

fn line(row: &Row) -> String {
    format!("{}\n", row.join(","))
}

/// Removes commas and line ends from messages, because they separate cells and rows.
fn clean(cell: &str) -> String {
    cell.replace(',', ";").replace(['\n', '\r'], " ")
}
