//! LU factorisation with partial pivoting, for the Jacobians J of the implicit flows.

use super::{SPARSE_FROM, Square};
use nalgebra::{SMatrix, SVector};

/// P J = L U.
pub(crate) struct Pivoted<const K: usize> {
    lu: Square<K>,
    order: [usize; K],
}

impl<const K: usize> Pivoted<K> {
    pub(crate) fn new() -> Self {
        Pivoted {
            lu: bytemuck::zeroed_box(),
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
        let ([x], lu) = (&mut x.data.0, &*self.lu);
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
}

/// Not a method: writes to what a field points to would make the optimiser read the field again after each.
fn eliminate<const K: usize>(lu: &mut [[f64; K]; K], order: &mut [usize; K]) -> bool {
    for k in 0..K {
        let mut best = k;
        for i in k + 1..K {
            if lu[i][k].abs() > lu[best][k].abs() {
                best = i;
            }
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
