//! LU factorisation with pivoting, for the Jacobians J of the implicit flows.
//!
//! J is M with the tangents of a short step, so that its diagonal serves as a rule. Where elimination has left little of a
//! diagonal entry, the largest entry of the column is taken. Rows of lengths and rows of angles have different units:
//! entries are compared by J_ik²/|J_ii|, which has the same unit in all rows, as J_ik and J_ii are energies by products of
//! velocities.

use super::lanes::{Lane, Substitution, scale, solve_rows, subtract};
use super::{RowMatrix, SPARSE_FROM, Square};
use nalgebra::{SMatrix, SVector};

/// P J = L U.
#[derive(Clone)]
pub(crate) struct Pivoted<const K: usize> {
    lu: Square<K>,
    order: [usize; K],
}

impl<const K: usize> Pivoted<K> {
    pub(crate) fn new() -> Self {
        Pivoted {
            lu: Square::zeros(),
            order: [0; K],
        }
    }

    /// Factors the matrix with these rows; false if it is singular to working precision or not finite.
    pub(crate) fn factor(&mut self, rows: &SMatrix<f64, K, K>) -> bool {
        self.lu.copy_from_slice(&rows.data.0);
        eliminate(&mut self.lu, &mut self.order)
    }

    /// x ← J⁻¹ x.
    pub(crate) fn solve(&self, x: &mut SVector<f64, K>) {
        let [x] = &mut x.data.0;
        self.one(x);
    }

    /// x ← J⁻¹ x for each row x.
    pub(crate) fn solve_rows<const R: usize>(&self, rows: &mut RowMatrix<K, R>) {
        solve_rows(self, rows.entries_mut());
    }
}

impl<const K: usize> Substitution<K> for Pivoted<K> {
    fn one(&self, x: &mut [f64; K]) {
        let lu = &*self.lu;
        // Whole rows were swapped, the multipliers with them: all exchanges come first.
        for k in 0..K {
            x.swap(k, self.order[k]);
        }
        for i in 1..K {
            for j in 0..i {
                x[i] -= lu[i][j] * x[j];
            }
        }
        for i in (0..K).rev() {
            for j in i + 1..K {
                x[i] -= lu[i][j] * x[j];
            }
            x[i] /= lu[i][i];
        }
    }

    fn several<const WIDTH: usize>(&self, x: &mut [Lane<WIDTH>; K]) {
        let lu = &*self.lu;
        for k in 0..K {
            x.swap(k, self.order[k]);
        }
        for i in 1..K {
            let mut value = x[i];
            for (&entry, known) in lu[i][..i].iter().zip(&x[..i]) {
                subtract(&mut value, entry, known);
            }
            x[i] = value;
        }
        for i in (0..K).rev() {
            let mut value = x[i];
            for (&entry, known) in lu[i][i + 1..].iter().zip(&x[i + 1..]) {
                subtract(&mut value, entry, known);
            }
            scale(&mut value, 1.0 / lu[i][i]);
            x[i] = value;
        }
    }
}

/// A diagonal entry is a pivot if this fraction of it is left.
const LEFT: f64 = 0.1;

/// Not a method: writes to what a field points to would make the optimiser read the field again after each.
fn eliminate<const K: usize>(lu: &mut [[f64; K]; K], order: &mut [usize; K]) -> bool {
    let mut diagonal: [f64; K] = core::array::from_fn(|i| lu[i][i].abs());
    for k in 0..K {
        let mut best = k;
        if !(lu[k][k].abs() >= LEFT * diagonal[k]) || diagonal[k] == 0.0 {
            best = largest(lu, &diagonal, k);
            diagonal.swap(k, best);
        }
        order[k] = best;
        lu.swap(k, best);
        let pivot_row = lu[k];
        let pivot = pivot_row[k];
        if !(pivot.abs() > f64::MIN_POSITIVE && pivot.is_finite()) {
            return false;
        }
        for i in k + 1..K {
            let row = &mut lu[i];
            if K >= SPARSE_FROM && row[k] == 0.0 {
                continue;
            }
            let factor = row[k] / pivot;
            row[k] = factor;
            for j in k + 1..K {
                row[j] -= factor * pivot_row[j];
            }
        }
    }
    true
}

/// The row with the largest entry of column k, from row k on.
#[cold]
#[inline(never)]
fn largest<const K: usize>(lu: &[[f64; K]; K], diagonal: &[f64; K], k: usize) -> usize {
    // A row without diagonal entry is compared as it is.
    let unit = |i: usize| if diagonal[i] == 0.0 { 1.0 } else { diagonal[i] };
    let mut best = k;
    for i in k + 1..K {
        // Written without a quotient.
        if lu[i][k] * lu[i][k] * unit(best) > lu[best][k] * lu[best][k] * unit(i) {
            best = i;
        }
    }
    best
}
