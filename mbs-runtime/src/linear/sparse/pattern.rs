//! Which entries of a matrix are not zero, column by column.

use super::Entries;
use std::collections::BTreeSet;

/// A pattern on its way.
pub(crate) struct Pattern {
    columns: Vec<BTreeSet<usize>>,
}

impl Pattern {
    /// No entries.
    pub(crate) fn new(columns: usize) -> Pattern {
        Pattern {
            columns: vec![BTreeSet::new(); columns],
        }
    }

    pub(crate) fn insert(&mut self, row: usize, column: usize) {
        self.columns[column].insert(row);
    }

    /// Gives three columns, from each of these on, all entries that one of them has: those of an angular velocity, which
    /// a rotation mixes.
    pub(crate) fn join_threes(&mut self, firsts: &[usize]) {
        for &first in firsts {
            let three = &mut self.columns[first..first + 3];
            let all: BTreeSet<usize> = three.iter().flatten().copied().collect();
            three.fill(all);
        }
    }

    pub(crate) fn finish(self) -> Columns {
        let mut starts = vec![0];
        let mut rows = Vec::new();
        for column in self.columns {
            rows.extend(column);
            starts.push(rows.len());
        }
        Columns { starts, rows }
    }
}

/// The rows of all entries, column by column.
#[derive(Clone)]
pub(crate) struct Columns {
    /// Where each column begins, and where the last one ends.
    pub(crate) starts: Vec<usize>,
    pub(crate) rows: Vec<usize>,
}

impl Columns {
    /// The index of an entry.
    ///
    /// # Panics
    /// If it is not part of the pattern.
    pub(crate) fn slot(&self, row: usize, column: usize) -> usize {
        let first = self.starts[column];
        let rows = &self.rows[first..self.starts[column + 1]];
        first + rows.binary_search(&row).expect("an entry of the pattern")
    }

    /// The indices of these entries.
    pub(crate) fn slots(&self, entries: &Entries) -> Vec<usize> {
        let places = entries.places.iter();
        places
            .map(|&(row, column)| self.slot(row, column))
            .collect()
    }

    /// The pattern with that of its transpose.
    pub(crate) fn with_transpose(&self) -> Columns {
        let mut pattern = Pattern::new(self.starts.len() - 1);
        for (row, column) in self.places() {
            pattern.insert(row, column);
            pattern.insert(column, row);
        }
        pattern.finish()
    }

    /// Row and column of each entry, in order.
    pub(crate) fn places(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let columns = self.starts.windows(2).enumerate();
        columns.flat_map(|(column, ends)| {
            let rows = &self.rows[ends[0]..ends[1]];
            rows.iter().map(move |&row| (row, column))
        })
    }
}
