//! The linear equations of a Newton step with multipliers:
//!
//! ```text
//! J x − Aᵀ λ = r,    Ã x = −g
//! ```
//!
//! by elimination of x. The R × R matrix Ã J⁻¹ Aᵀ is factored with complete pivoting; rows whose pivots are round-off are
//! left out, and their multipliers are zero: the treatment of redundant rows that codes of this kind have.

use crate::linear::{Pivoted, RowMatrix, accumulate, dot, entries, entries_mut};
use nalgebra::SVector;

/// Pivots below this fraction of the largest are round-off.
const DEPENDENT: f64 = 1e-11;

#[derive(Clone)]
pub(crate) struct Saddle<const N: usize, const R: usize> {
    jacobian: Box<Pivoted<N>>,
    /// J⁻¹Aᵀ, row by row.
    along: RowMatrix<N, R>,
    matrix: RowMatrix<R, R>,
    /// Which row and which column the elimination took at each pivot.
    order: [[usize; R]; 2],
    scale: SVector<f64, R>,
    rank: usize,
    /// Pivots below this fraction of the largest belong to rows that follow from others.
    threshold: f64,
}

impl<const N: usize, const R: usize> Saddle<N, R> {
    pub(crate) fn new() -> Self {
        Self::with_threshold(DEPENDENT)
    }

    /// For poses that violate the rows, where those that follow from others are not quite dependent.
    pub(crate) fn with_threshold(threshold: f64) -> Self {
        Saddle {
            threshold,
            jacobian: Box::new(Pivoted::new()),
            along: RowMatrix::zeros(),
            matrix: RowMatrix::zeros(),
            order: [[0; R]; 2],
            scale: SVector::zeros(),
            rank: 0,
        }
    }

    /// Factors the equations; false if J is singular, or if J or a row is not finite.
    pub(crate) fn factor(
        &mut self,
        jacobian: &RowMatrix<N, N>,
        a: &RowMatrix<N, R>,
        a_moved: &RowMatrix<N, R>,
    ) -> bool {
        if !self.jacobian.factor(jacobian) {
            return false;
        }
        self.along.overwrite(a);
        self.jacobian.solve_rows(&mut self.along);
        for i in 0..R {
            let length = dot(&a_moved[i], &self.along[i]).abs();
            if !length.is_finite() {
                return false;
            }
            self.scale[i] = if length > f64::MIN_POSITIVE {
                1.0 / length.sqrt()
            } else {
                0.0
            };
        }
        let scale = entries(&self.scale);
        for (i, row) in self.matrix.entries_mut().iter_mut().enumerate() {
            for j in 0..R {
                row[j] = scale[i] * dot(&a_moved[i], &self.along[j]) * scale[j];
            }
        }
        self.eliminate();
        true
    }

    fn eliminate(&mut self) {
        let matrix = self.matrix.entries_mut();
        let mut first = 0.0;
        self.rank = R;
        for k in 0..R {
            let (mut row, mut column, mut most) = (k, k, 0.0);
            for i in k..R {
                for j in k..R {
                    if matrix[i][j].abs() > most {
                        (row, column, most) = (i, j, matrix[i][j].abs());
                    }
                }
            }
            if k == 0 {
                first = most;
            }
            if !(most > self.threshold * first) {
                self.rank = k;
                return;
            }
            (self.order[0][k], self.order[1][k]) = (row, column);
            matrix.swap(k, row);
            for line in matrix.iter_mut() {
                line.swap(k, column);
            }
            let pivot_row = matrix[k];
            for line in &mut matrix[k + 1..] {
                let factor = line[k] / pivot_row[k];
                line[k] = factor;
                for j in k + 1..R {
                    line[j] -= factor * pivot_row[j];
                }
            }
        }
    }

    /// How many rows the last factorisation left out.
    pub(crate) fn left_out(&self) -> usize {
        R - self.rank
    }

    /// The number of rows that the last factorisation kept; these rows and those whose multipliers it has come first in the
    /// two lists.
    pub(crate) fn kept(&self) -> (usize, [[usize; R]; 2]) {
        let lists = self.order.map(|exchanges| {
            let mut order: [usize; R] = std::array::from_fn(|row| row);
            for k in 0..self.rank {
                order.swap(k, exchanges[k]);
            }
            order
        });
        (self.rank, lists)
    }

    /// About 1/|a| of each row, in the metric of J⁻¹.
    pub(crate) fn row_scale(&self, row: usize) -> f64 {
        self.scale[row]
    }

    /// r becomes x, −g becomes λ.
    pub(crate) fn solve(
        &self,
        x: &mut SVector<f64, N>,
        rows: &mut SVector<f64, R>,
        a_moved: &RowMatrix<N, R>,
    ) {
        self.jacobian.solve(x);
        for i in 0..R {
            rows[i] = self.scale[i] * (rows[i] - dot(&a_moved[i], x));
        }
        self.solve_rows(rows);
        accumulate(x, &self.along, rows);
    }

    fn solve_rows(&self, rows: &mut SVector<f64, R>) {
        let (rank, matrix, scale) = (self.rank, &self.matrix.data.0, entries(&self.scale));
        let rows = entries_mut(rows);
        for k in 0..rank {
            rows.swap(k, self.order[0][k]);
        }
        for i in 0..rank {
            for j in 0..i {
                rows[i] -= matrix[i][j] * rows[j];
            }
        }
        for i in (0..rank).rev() {
            for j in i + 1..rank {
                rows[i] -= matrix[i][j] * rows[j];
            }
            rows[i] /= matrix[i][i];
        }
        rows[rank..].fill(0.0);
        for k in (0..rank).rev() {
            rows.swap(k, self.order[1][k]);
        }
        for i in 0..R {
            rows[i] *= scale[i];
        }
    }
}
