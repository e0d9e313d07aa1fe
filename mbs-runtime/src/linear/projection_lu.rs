//! The multiplier solve of the position rows, whose matrix B is not symmetric.

use super::proximal::Proximal;
use super::{SPARSE_FROM, Square};
use crate::singular::Thresholds;
use nalgebra::{SMatrix, SVector};

/// B = A₁ W₀ factored: plain elimination while B is well conditioned, the proximal solve where it is not.
///
/// B differs from the positive definite A₀M⁻¹A₀ᵀ by O(h), so that elimination needs no pivoting; a pivot that is small
/// relative to a M⁻¹aᵀ of its row shows a redundant row or a singular pose.
#[derive(Clone)]
pub(crate) struct ProjectionLu<const K: usize> {
    lu: Square<K>,
    inverse_pivot: [f64; K],
    proximal: Proximal<K>,
    /// Whether the last factorisation is the proximal one.
    pub(crate) regularised: bool,
    pub(crate) thresholds: Thresholds,
}

impl<const K: usize> ProjectionLu<K> {
    pub(crate) fn new() -> Self {
        ProjectionLu {
            lu: Square::zeros(),
            inverse_pivot: [0.0; K],
            proximal: Proximal::new(),
            regularised: false,
            thresholds: Thresholds::SECOND_ORDER,
        }
    }

    /// Factors the matrix with these rows; `length_squared[i]` is a_i M⁻¹ a_iᵀ, or what is usual where that is more.
    /// Skipped rows, where there are any, get no multiplier.
    #[inline(always)]
    pub(crate) fn factor(
        &mut self,
        rows: &SMatrix<f64, K, K>,
        length_squared: &SVector<f64, K>,
        skipped: Option<&[bool; K]>,
    ) {
        let (matrix, [length_squared]) = (&rows.data.0, &length_squared.data.0);
        let regular = match skipped {
            None => self.eliminate(|_| false, matrix, length_squared),
            Some(skipped) => self.eliminate_but(skipped, matrix, length_squared),
        };
        self.regularised = !regular;
        if self.regularised {
            self.proximal.factor(matrix, length_squared);
        }
    }

    /// Elimination past skipped rows. Not inlined, so that the compiler unrolls only the other form.
    #[inline(never)]
    fn eliminate_but(
        &mut self,
        skipped: &[bool; K],
        matrix: &[[f64; K]; K],
        length_squared: &[f64; K],
    ) -> bool {
        self.eliminate(|k| skipped[k], matrix, length_squared)
    }

    /// Elimination; false at the first pivot that is small (or not a number).
    #[inline(always)]
    fn eliminate(
        &mut self,
        skipped: impl Fn(usize) -> bool,
        matrix: &[[f64; K]; K],
        length_squared: &[f64; K],
    ) -> bool {
        self.lu.copy_from_slice(matrix);
        let lu = &mut self.lu;
        for k in 0..K {
            let pivot_row = lu[k];
            let pivot = pivot_row[k];
            if skipped(k) {
                self.inverse_pivot[k] = 0.0;
                for row in &mut lu[k + 1..] {
                    row[k] = 0.0;
                }
                continue;
            }
            if !(pivot.abs() > self.thresholds.lost * length_squared[k]) {
                return false;
            }
            let inverse = 1.0 / pivot;
            self.inverse_pivot[k] = inverse;
            for i in k + 1..K {
                let row = &mut lu[i];
                if K >= SPARSE_FROM && row[k] == 0.0 {
                    continue;
                }
                let factor = row[k] * inverse;
                row[k] = factor;
                for j in k + 1..K {
                    row[j] -= factor * pivot_row[j];
                }
            }
        }
        true
    }

    /// The smallest pivot relative to the length of its row, with its sign; 0 after a fall-back.
    pub(crate) fn smallest_pivot(&self, length_squared: &SVector<f64, K>) -> f64 {
        if self.regularised {
            return 0.0;
        }
        let relative = |(inverse, length): (&f64, &f64)| 1.0 / (inverse * length);
        self.inverse_pivot
            .iter()
            .zip(length_squared.iter())
            .map(relative)
            .fold(f64::INFINITY, f64::min)
    }

    /// x ← B⁻¹ x, or the least-squares x ← Bᵀ(BBᵀ + εI)⁻¹x on rows of unit length.
    #[inline(always)]
    pub(crate) fn solve(&self, x: &mut SVector<f64, K>) {
        let [x] = &mut x.data.0;
        if self.regularised {
            return self.proximal.solve(x);
        }
        for i in 1..K {
            let mut sum = x[i];
            for j in 0..i {
                sum -= self.lu[i][j] * x[j];
            }
            x[i] = sum;
        }
        for i in (0..K).rev() {
            let mut sum = x[i];
            for j in i + 1..K {
                sum -= self.lu[i][j] * x[j];
            }
            x[i] = sum * self.inverse_pivot[i];
        }
    }
}
