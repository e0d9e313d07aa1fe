//! A sparse matrix, row by row.

/// The entries of each row, by ascending columns.
#[derive(Debug, Clone)]
pub(crate) struct SparseRows {
    /// Where each row begins, and where the last one ends.
    starts: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl SparseRows {
    /// A matrix with this number of rows. Of entries at the same place the last one counts.
    pub(crate) fn new(rows: usize, mut entries: Vec<(usize, usize, f64)>) -> SparseRows {
        // Stable: the last one of a place stays last.
        entries.sort_by_key(|&(row, column, _)| (row, column));
        let mut matrix = SparseRows {
            starts: vec![0; rows + 1],
            columns: Vec::with_capacity(entries.len()),
            values: Vec::with_capacity(entries.len()),
        };
        for (k, &(row, column, value)) in entries.iter().enumerate() {
            let next = entries.get(k + 1).map(|&(row, column, _)| (row, column));
            if next != Some((row, column)) {
                matrix.columns.push(column);
                matrix.values.push(value);
                matrix.starts[row + 1] = matrix.columns.len();
            }
        }
        for row in 0..rows {
            // Rows without entries end where they begin.
            matrix.starts[row + 1] = matrix.starts[row + 1].max(matrix.starts[row]);
        }
        matrix
    }

    /// The number of rows.
    pub(crate) fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Columns and values of a row.
    pub(crate) fn row(&self, row: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.starts[row]..self.starts[row + 1];
        let columns = self.columns[range.clone()].iter().copied();
        columns.zip(self.values[range].iter().copied())
    }

    /// An entry; 0 where none is stored.
    pub(crate) fn get(&self, row: usize, column: usize) -> f64 {
        let range = self.starts[row]..self.starts[row + 1];
        match self.columns[range.clone()].binary_search(&column) {
            Ok(place) => self.values[range.start + place],
            Err(_) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::SparseRows;

    #[test]
    fn entries_come_in_any_order() {
        let entries = [(3, 1, 4.0), (0, 2, 1.0), (3, 0, 2.0), (0, 2, 5.0)];
        let matrix = SparseRows::new(5, entries.to_vec());
        assert_eq!(matrix.count(), 5);
        let row = |row| matrix.row(row).collect::<Vec<_>>();
        assert_eq!(row(0), [(2, 5.0)]);
        assert_eq!(row(3), [(0, 2.0), (1, 4.0)]);
        assert!([1, 2, 4].iter().all(|&empty| row(empty).is_empty()));
        assert_eq!((matrix.get(3, 1), matrix.get(3, 2)), (4.0, 0.0));
    }
}
