//! L D Lᵀ of a sparse symmetric matrix in its own order: each row is eliminated by those before it that it meets.

use super::SparseRows;

/// The factor, row by row.
#[derive(Debug, Clone)]
pub(crate) struct Ldl {
    /// Where each row of L begins, and where the last one ends.
    starts: Vec<usize>,
    columns: Vec<usize>,
    /// The entries of L left of its diagonal of ones.
    values: Vec<f64>,
    inverse_pivots: Vec<f64>,
}

impl Ldl {
    /// The factor of a matrix, of which the lower triangle is read. `inverse` is 1/d of a pivot, from its row, d and the
    /// diagonal entry; with `None` it refuses the pivot. (A trait object, so that this is compiled once and not for each
    /// mechanism.)
    ///
    /// # Errors
    /// The row whose pivot was refused.
    pub(crate) fn new(
        matrix: &SparseRows,
        inverse: &dyn Fn(usize, f64, f64) -> Option<f64>,
    ) -> Result<Ldl, usize> {
        let size = matrix.count();
        let mut factor = Ldl {
            starts: vec![0],
            columns: Vec::new(),
            values: Vec::new(),
            inverse_pivots: Vec::with_capacity(size),
        };
        // The next row that a row is needed for, and the last row that met it.
        let (mut parents, mut met) = (vec![usize::MAX; size], vec![usize::MAX; size]);
        let mut wide = vec![0.0; size];
        let mut reached = Vec::new();
        for i in 0..size {
            met[i] = i;
            let (mut whole, mut pivot) = (0.0, 0.0);
            reached.clear();
            for (column, value) in matrix.row(i).filter(|&(column, _)| column <= i) {
                if column == i {
                    (whole, pivot) = (value, value);
                    continue;
                }
                wide[column] = value;
                let mut k = column;
                while met[k] != i {
                    met[k] = i;
                    reached.push(k);
                    if parents[k] == usize::MAX {
                        parents[k] = i;
                    }
                    k = parents[k];
                }
            }
            reached.sort_unstable();
            for &k in &reached {
                let row = factor.starts[k]..factor.starts[k + 1];
                let terms = factor.columns[row.clone()].iter();
                let terms = terms.zip(&factor.values[row]);
                wide[k] -= terms.map(|(&j, value)| value * wide[j]).sum::<f64>();
            }
            for &k in &reached {
                let entry = wide[k] * factor.inverse_pivots[k];
                pivot -= entry * wide[k];
                factor.columns.push(k);
                factor.values.push(entry);
                wide[k] = 0.0;
            }
            factor.starts.push(factor.columns.len());
            factor
                .inverse_pivots
                .push(inverse(i, pivot, whole).ok_or(i)?);
        }
        Ok(factor)
    }

    /// The number of rows.
    pub(crate) fn size(&self) -> usize {
        self.inverse_pivots.len()
    }

    fn row(&self, row: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.starts[row]..self.starts[row + 1];
        let columns = self.columns[range.clone()].iter().copied();
        columns.zip(self.values[range].iter().copied())
    }

    /// x ← (L D Lᵀ)⁻¹x.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        let size = self.size();
        for i in 0..size {
            x[i] -= self.row(i).map(|(j, value)| value * x[j]).sum::<f64>();
        }
        for i in (0..size).rev() {
            // Those below have been subtracted.
            x[i] *= self.inverse_pivots[i];
        }
        for i in (0..size).rev() {
            let solved = x[i];
            for (j, value) in self.row(i) {
                x[j] -= value * solved;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Ldl, SparseRows};

    #[test]
    fn a_ring_of_springs_is_solved() {
        // Neighbours, and the ends with each other: with fill in the last row.
        let size = 7;
        let mut entries = Vec::new();
        for i in 0..size {
            let next = (i + 1) % size;
            entries.push((i, i, 3.0 + i as f64));
            entries.extend([(i, next, -1.0), (next, i, -1.0)]);
        }
        let matrix = SparseRows::new(size, entries);
        let factor = Ldl::new(&matrix, &|_, pivot, _| Some(1.0 / pivot)).unwrap();
        let solution: Vec<f64> = (0..size).map(|i| (i as f64).cos()).collect();
        let product = |i: usize| matrix.row(i).map(|(j, value)| value * solution[j]).sum();
        let mut x: Vec<f64> = (0..size).map(product).collect();
        factor.solve(&mut x);
        for (x, wanted) in x.iter().zip(&solution) {
            assert!((x - wanted).abs() < 1e-14, "{x} {wanted}");
        }
    }

    #[test]
    fn a_pivot_can_be_refused() {
        let matrix = SparseRows::new(2, vec![(0, 0, 1.0), (1, 0, 2.0), (1, 1, 4.0)]);
        let refused = Ldl::new(&matrix, &|_, pivot, _| (pivot > 0.0).then(|| 1.0 / pivot));
        assert_eq!(refused.err(), Some(1));
    }
}
