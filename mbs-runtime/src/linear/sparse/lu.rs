//! The factors of a sparse matrix of fixed pattern.

use super::Columns;
use super::frontal::FrontalLu;
use super::pivoted_lu::PivotedLu;

/// A square matrix, and its factors: with the pivots on the diagonal if it is that of a mechanism without rows and no pivot
/// is small, otherwise with exchanges of rows.
#[derive(Clone)]
pub(crate) struct SparseLu {
    columns: Columns,
    values: Vec<f64>,
    diagonal: Option<Box<FrontalLu>>,
    pivoted: Option<Box<PivotedLu>>,
    factored: Factored,
}

#[derive(Clone, Copy, PartialEq)]
enum Factored {
    No,
    Diagonal,
    Pivoted,
}

impl SparseLu {
    /// A matrix of zeros; `None` if the pattern is singular, or there is no memory.
    pub(crate) fn new(columns: &Columns) -> Option<SparseLu> {
        let pivoted = Some(Box::new(PivotedLu::new(columns)?));
        Some(SparseLu {
            columns: columns.clone(),
            values: vec![0.0; columns.rows.len()],
            diagonal: None,
            pivoted,
            factored: Factored::No,
        })
    }

    /// The same for matrices whose pivots are expected on the diagonal, as M with what short steps add to it.
    pub(crate) fn with_diagonal_pivots(columns: &Columns) -> Option<SparseLu> {
        Some(SparseLu {
            columns: columns.clone(),
            values: vec![0.0; columns.rows.len()],
            diagonal: Some(Box::new(FrontalLu::new(columns)?)),
            pivoted: None,
            factored: Factored::No,
        })
    }

    /// The entries, in the order of the pattern, to be written.
    pub(crate) fn values(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Factors the matrix; false if an entry is not finite, or the matrix is singular by its pattern. (faer does not
    /// report other singular matrices: [`Self::solve`] does.)
    #[must_use]
    pub(crate) fn factor(&mut self) -> bool {
        self.factored = Factored::No;
        if !self.values.iter().all(|value| value.is_finite()) {
            return false;
        }
        self.factored = if let Some(lu) = &mut self.diagonal
            && lu.factor(&self.values)
        {
            Factored::Diagonal
        } else if self.factor_pivoted() {
            Factored::Pivoted
        } else {
            Factored::No
        };
        self.factored != Factored::No
    }

    /// Analyses the pattern when it is first needed.
    fn factor_pivoted(&mut self) -> bool {
        if self.pivoted.is_none() {
            self.pivoted = PivotedLu::new(&self.columns).map(Box::new);
        }
        let lu = self.pivoted.as_mut();
        lu.is_some_and(|lu| lu.factor(&self.values))
    }

    /// x ← K⁻¹x; false, and x is of no use, if that is not finite.
    #[must_use]
    pub(crate) fn solve(&mut self, x: &mut [f64]) -> bool {
        match self.factored {
            Factored::No => return false,
            Factored::Diagonal => self.diagonal.iter_mut().for_each(|lu| lu.solve(x)),
            Factored::Pivoted => self.pivoted.iter_mut().for_each(|lu| lu.solve(x)),
        }
        x.iter().all(|value| value.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Pattern;
    use super::SparseLu;

    fn matrix(size: usize, entries: &[(usize, usize, f64)], diagonal: bool) -> SparseLu {
        let mut pattern = Pattern::new(size);
        entries.iter().for_each(|&(i, j, _)| pattern.insert(i, j));
        let columns = pattern.finish();
        let lu = match diagonal {
            true => SparseLu::with_diagonal_pivots(&columns),
            false => SparseLu::new(&columns),
        };
        let mut lu = lu.unwrap();
        for &(i, j, value) in entries {
            lu.values()[columns.slot(i, j)] = value;
        }
        lu
    }

    #[test]
    fn rows_are_exchanged_where_a_pivot_is_zero() {
        for diagonal in [false, true] {
            let entries = [(0, 1, 2.0), (1, 0, 4.0), (2, 2, 1.0), (2, 0, 1.0)];
            let mut lu = matrix(3, &entries, diagonal);
            assert!(lu.factor());
            let mut x = [2.0, 4.0, 3.0];
            assert!(lu.solve(&mut x));
            assert_eq!(x, [1.0, 1.0, 2.0]);
        }
    }

    #[test]
    fn what_cannot_be_solved_is_said() {
        for diagonal in [false, true] {
            let entries = [(0, 0, 1.0), (0, 1, 1.0), (1, 0, 1.0), (1, 1, 1.0)];
            let mut lu = matrix(2, &entries, diagonal);
            assert!(!lu.factor() || !lu.solve(&mut [1.0, 2.0]));
            lu.values()[0] = f64::NAN;
            assert!(!lu.factor() && !lu.solve(&mut [1.0, 2.0]));
        }
    }
}
