//! L U of a sparse matrix with exchanges of rows, by faer: the pattern is analysed once.

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

/// A matrix, and its factors.
pub(super) struct PivotedLu {
    matrix: SparseColMat<usize, f64>,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, f64>,
    memory: MemBuffer,
}

/// Working memory for factors and solutions of a pattern.
fn scratch(symbolic: &SymbolicLu<usize>) -> MemBuffer {
    let of_factor = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default());
    let of_solve = symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
    MemBuffer::new(of_factor.or(of_solve))
}

/// Working memory holds nothing between calls.
impl Clone for PivotedLu {
    fn clone(&self) -> Self {
        PivotedLu {
            matrix: self.matrix.clone(),
            symbolic: self.symbolic.clone(),
            numeric: self.numeric.clone(),
            memory: scratch(&self.symbolic),
        }
    }
}

impl PivotedLu {
    /// A matrix of zeros; `None` if the pattern is singular, or there is no memory.
    pub(super) fn new(columns: &Columns) -> Option<PivotedLu> {
        let size = columns.starts.len() - 1;
        let (starts, rows) = (columns.starts.clone(), columns.rows.clone());
        let values = vec![0.0; rows.len()];
        let pattern = SymbolicSparseColMat::new_checked(size, size, starts, None, rows);
        let parameters = LuSymbolicParams {
            supernodal_flop_ratio_threshold: GROUPED,
            ..LuSymbolicParams::default()
        };
        let symbolic = factorize_symbolic_lu(pattern.as_ref(), parameters).ok()?;
        Some(PivotedLu {
            matrix: SparseColMat::new(pattern, values),
            memory: scratch(&symbolic),
            symbolic,
            numeric: NumericLu::new(),
        })
    }

    /// Factors the matrix of these entries, in the order of the pattern; false if it is singular by its pattern. Other
    /// singular matrices are not noticed.
    #[must_use]
    pub(super) fn factor(&mut self, entries: &[f64]) -> bool {
        self.matrix.val_mut().copy_from_slice(entries);
        let factors = self.symbolic.factorize_numeric_lu(
            &mut self.numeric,
            self.matrix.as_ref(),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Default::default(),
        );
        factors.is_ok()
    }

    /// x ← K⁻¹x.
    pub(super) fn solve(&mut self, x: &mut [f64]) {
        let factors = LuRef::new_unchecked(&self.symbolic, &self.numeric);
        let right = ColMut::from_slice_mut(x).as_mat_mut();
        let stack = MemStack::new(&mut self.memory);
        factors.solve_in_place_with_conj(Conj::No, right, Par::Seq, stack);
    }
}
