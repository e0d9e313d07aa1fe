//! The CSV files below `book/src/results`.

use std::fs;
use std::path::{Path, PathBuf};

use crate::laboratory::store::Row;

/// Where results are, from the top of the repository.
pub const RESULTS: &str = "book/src/results";

/// The results of one repository.
#[derive(Debug, Clone)]
pub struct Data {
    directory: PathBuf,
}

impl Data {
    /// Of the repository with this top.
    pub fn new(root: &Path) -> Self {
        Data {
            directory: root.join(RESULTS),
        }
    }

    /// A file by its path below `book/src/results`.
    ///
    /// # Errors
    /// A file that cannot be read, or a row with another number of cells than the heading.
    pub fn table(&self, file: &str) -> Result<Table, String> {
        let text = fs::read_to_string(self.directory.join(file))
            .map_err(|error| format!("{RESULTS}/{file}: {error}"))?;
        Table::parse(file, &text)
    }
}

/// A file that was read.
#[derive(Debug, Clone)]
pub struct Table {
    file: String,
    /// Its first line: commit, machine, and how it was measured.
    pub note: String,
    columns: Vec<String>,
    /// Its rows.
    pub rows: Vec<Row>,
}

impl Table {
    /// From the text of a file.
    ///
    /// # Errors
    /// As [`Data::table`].
    pub fn parse(file: &str, text: &str) -> Result<Self, String> {
        let (notes, lines): (Vec<&str>, Vec<&str>) =
            text.lines().partition(|line| line.starts_with('#'));
        let split = |line: &&str| line.split(',').map(str::to_owned).collect::<Row>();
        let mut rows = lines.iter().map(split);
        let columns = rows.next().ok_or_else(|| format!("{file} is empty"))?;
        let rows: Vec<Row> = rows.collect();
        if let Some(row) = rows.iter().find(|row| row.len() != columns.len()) {
            return Err(format!(
                "{file}: row `{}` has not all columns",
                row.join(",")
            ));
        }
        let note = notes
            .first()
            .map_or("", |note| note.trim_start_matches("# "));
        Ok(Table {
            file: file.to_owned(),
            note: note.to_owned(),
            columns,
            rows,
        })
    }

    /// `commit …, machine …`, for sentences.
    pub fn source(&self) -> String {
        let parts: Vec<&str> = self.note.split("; ").take(2).collect();
        parts.join(", ")
    }

    /// All rows.
    pub fn lines(&self) -> impl Iterator<Item = Line<'_>> {
        self.rows.iter().map(|row| Line { table: self, row })
    }

    /// The first row with these cells.
    ///
    /// # Errors
    /// There is no such row.
    pub fn find(&self, cells: &[(&str, &str)]) -> Result<Line<'_>, String> {
        let fits = |line: &Line| {
            cells
                .iter()
                .all(|(column, cell)| line.text(column).is_ok_and(|text| text == *cell))
        };
        self.lines()
            .find(fits)
            .ok_or_else(|| format!("{}: no row with {cells:?}", self.file))
    }
}

/// A row with its columns' names.
#[derive(Debug, Clone, Copy)]
pub struct Line<'t> {
    table: &'t Table,
    row: &'t Row,
}

impl<'t> Line<'t> {
    /// A cell.
    ///
    /// # Errors
    /// The file has no such column.
    pub fn text(&self, column: &str) -> Result<&'t str, String> {
        let index = self.table.columns.iter().position(|name| name == column);
        let cell = index.and_then(|index| self.row.get(index));
        cell.map(String::as_str)
            .ok_or_else(|| format!("{} has no column `{column}`", self.table.file))
    }

    /// A cell as a number.
    ///
    /// # Errors
    /// It is not a number.
    pub fn number(&self, column: &str) -> Result<f64, String> {
        let text = self.text(column)?;
        let number = text.parse();
        number.map_err(|_| format!("{}: `{text}` in `{column}` is no number", self.table.file))
    }
}
