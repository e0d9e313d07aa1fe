//! LU factors of a sparse matrix, by faer: the pattern is analysed once.

use super::pattern::Columns;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::lu::{
    LuRef, LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu,
};
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use faer::{ColMut, Conj, Par};

/// Columns are eliminated in groups where an entry of the factors takes more operations than 20 (half of what faer takes):
/// groups are the faster in a grid, single columns in a chain.
const GROUPED: SupernodalThreshold = SupernodalThreshold(0.5);

/// A square matrix of fixed pattern, and its factors.
pub(crate) struct SparseLu {
    matrix: SparseColMat<usize, f64>,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, f64>,
    memory: MemBuffer,
    factored: bool,
}

/// Working memory for factors and solutions of a pattern.
fn scratch(symbolic: &SymbolicLu<usize>) -> MemBuffer {
    let of_factor = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default());
    let of_solve = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
    MemBuffer::new(of_factor.or(of_solve))
}

/// Working memory holds nothing between calls.
impl Clone for SparseLu {
    fn clone(&self) -> Self {
        SparseLu {
            matrix: self.matrix.clone(),
            symbolic: self.symbolic.clone(),
            numeric: self.numeric.clone(),
            memory: scratch(&self.symbolic),
            factored: self.factored,
        }
    }
}

impl SparseLu {
    /// A matrix of zeros; `None` if the pattern is singular, or there is no memory.
    pub(crate) fn new(columns: &Columns) -> Option<SparseLu> {
        let size = columns.starts.len() - 1;
        let (starts, rows) = (columns.starts.clone(), columns.rows.clone());
        let values = vec![0.0; rows.len()];
        let pattern = SymbolicSparseColMat::new_checked(size, size, starts, None, rows);
        let parameters = LuSymbolicParams {
            supernodal_flop_ratio_threshold: GROUPED,
            ..LuSymbolicParams::default()
        };
        let symbolic = factorize_symbolic_lu(pattern.as_ref(), parameters).ok()?;
        Some(SparseLu {
            matrix: SparseColMat::new(pattern, values),
            memory: scratch(&symbolic),
            symbolic,
            numeric: NumericLu::new(),
            factored: false,
        })
    }

    /// The entries, in the order of the pattern, to be written.
    pub(crate) fn values(&mut self) -> &mut [f64] {
        self.matrix.val_mut()
    }

    /// Factors the matrix; false if an entry is not finite, or the matrix is singular by its pattern. (faer does not
    /// report other singular matrices: [`Self::solve`] does.)
    #[must_use]
    pub(crate) fn factor(&mut self) -> bool {
        self.factored = false;
        if !self.matrix.val().iter().all(|value| value.is_finite()) {
            return false;
        }
        let factors = self.symbolic.factorize_numeric_lu(
            &mut self.numeric,
            self.matrix.as_ref(),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Default::default(),
        );
        self.factored = factors.is_ok();
        self.factored
    }

    /// x ← K⁻¹x; false, and x is of no use, if that is not finite.
    #[must_use]
    pub(crate) fn solve(&mut self, x: &mut [f64]) -> bool {
        if !self.factored {
            return false;
        }
        let factors = LuRef::new_unchecked(&self.symbolic, &self.numeric);
        let right = ColMut::from_slice_mut(x).as_mat_mut();
        let stack = MemStack::new(&mut self.memory);
        factors.solve_in_place_with_conj(Conj::No, right, Par::Seq, stack);
        x.iter().all(|value| value.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Pattern;
    use super::SparseLu;

    fn matrix(size: usize, entries: &[(usize, usize, f64)]) -> SparseLu {
        let mut pattern = Pattern::new(size);
        entries.iter().for_each(|&(i, j, _)| pattern.insert(i, j));
        let columns = pattern.finish();
        let mut lu = SparseLu::new(&columns).unwrap();
        for &(i, j, value) in entries {
            lu.values()[columns.slot(i, j)] = value;
        }
        lu
    }

    #[test]
    fn rows_are_exchanged_where_a_pivot_is_zero() {
        let mut lu = matrix(3, &[(0, 1, 2.0), (1, 0, 4.0), (2, 2, 1.0), (2, 0, 1.0)]);
        assert!(lu.factor());
        let mut x = [2.0, 4.0, 3.0];
        assert!(lu.solve(&mut x));
        assert_eq!(x, [1.0, 1.0, 2.0]);
    }

    #[test]
    fn what_cannot_be_solved_is_said() {
        let mut lu = matrix(2, &[(0, 0, 1.0), (0, 1, 1.0), (1, 0, 1.0), (1, 1, 1.0)]);
        assert!(!lu.factor() || !lu.solve(&mut [1.0, 2.0]));
        lu.values()[0] = f64::NAN;
        assert!(!lu.factor() && !lu.solve(&mut [1.0, 2.0]));
    }
}
