//! M and A as lists of their entries, for large mechanisms.

use super::{Constraints, Inertia};
use crate::linear::sparse::SparseRows;
use crate::{MatrixSink, linear::zeros};
use nalgebra::SVector;

/// Row, column and value of each entry that a function writes.
#[derive(Default)]
struct Listed(Vec<(usize, usize, f64)>);

impl MatrixSink for Listed {
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.0.push((row, column, value));
    }
}

/// M(q).
pub(crate) fn mass_rows<S: Inertia<Q, N>, const Q: usize, const N: usize>(
    system: &S,
    q: &SVector<f64, Q>,
) -> SparseRows {
    let mut mass = Listed::default();
    system.mass_matrix(q, &mut mass);
    SparseRows::new(N, mass.0)
}

/// A(q, t).
pub(crate) fn constraint_rows<
    S: Constraints<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    system: &S,
    t: f64,
    q: &SVector<f64, Q>,
) -> SparseRows {
    let mut a = Listed::default();
    system.constraints(t, q, &mut zeros(), &mut a, &mut zeros());
    SparseRows::new(R, a.0)
}
