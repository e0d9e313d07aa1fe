//! Aligned columns of text.

use std::fmt::Write as _;

/// How the cells of a column are aligned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Align {
    /// Text.
    Left,
    /// Numbers.
    Right,
}

/// A heading and rows, indented by two spaces, every column as wide as its widest cell.
pub fn table<const COLUMNS: usize>(
    heading: [(&str, Align); COLUMNS],
    rows: &[[String; COLUMNS]],
) -> String {
    let widths: [usize; COLUMNS] = std::array::from_fn(|column| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.fold(heading[column].0.chars().count(), usize::max)
    });
    let mut text = String::new();
    let heading_row = heading.map(|(name, _)| name.to_owned());
    for row in std::iter::once(&heading_row).chain(rows) {
        let mut line = String::from(" ");
        for column in 0..COLUMNS {
            let (cell, width) = (&row[column], widths[column]);
            // Writing to a String cannot fail.
            let _ = match heading[column].1 {
                Align::Left => write!(line, " {cell:<width$} "),
                Align::Right => write!(line, " {cell:>width$} "),
            };
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}
