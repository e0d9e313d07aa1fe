//! M, A and ∂f/∂q as lists of their entries, for large mechanisms.

use super::{Constraints, Inertia, Loads};
use crate::linear::sparse::SparseRows;
use crate::linear::zeros;
use crate::sink::{Discard, MatrixSink};
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

/// ∂f/∂q of the applied forces at (t, q, v).
pub(crate) fn force_slopes<S: Loads<Q, N>, const Q: usize, const N: usize>(
    system: &S,
    t: f64,
    (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
) -> SparseRows {
    let mut slopes = Listed::default();
    system.applied_force_tangents(t, q, v, &mut slopes, &mut Discard);
    SparseRows::new(N, slopes.0)
}
