//! The proximal (augmented Lagrangian) solve in the dual: Bᵀ(BBᵀ + εI)⁻¹ on rows of unit length.
//!
//! It is one step of the augmented Lagrangian iteration with penalty 1/√ε, written for the multipliers: the
//! multipliers of redundant rows are those of least norm, and that of a row without direction is zero.

use super::{Square, dot_of as dot};
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::singular::{PASSED, PASSES, PROXIMAL, SHRINKS};

/// Kept by [`memory`](crate::memory), because it is seldom used and large systems are built on small stacks.
#[derive(Clone)]
pub(crate) struct Proximal<const K: usize> {
    /// B with rows and columns scaled.
    scaled: Square<K>,
    /// Cholesky factor of BBᵀ + εI, lower.
    factor: Square<K>,
    /// 1/√(a M⁻¹ aᵀ), row by row.
    scale: [f64; K],
}

impl<const K: usize> Proximal<K> {
    pub(super) fn new() -> Self {
        Proximal {
            scaled: Square::zeros(),
            factor: Square::zeros(),
            scale: [0.0; K],
        }
    }

    /// Not inlined, because well conditioned steps do not need it.
    #[cold]
    #[inline(never)]
    pub(super) fn factor(&mut self, matrix: &[[f64; K]; K], length_squared: &[f64; K]) {
        for i in 0..K {
            // A row that vanishes altogether gets no multiplier.
            let length = length_squared[i].abs();
            self.scale[i] = if length > f64::MIN_POSITIVE {
                1.0 / length.sqrt()
            } else {
                0.0
            };
        }
        for i in 0..K {
            for j in 0..K {
                self.scaled[i][j] = self.scale[i] * matrix[i][j] * self.scale[j];
            }
        }
        for i in 0..K {
            for j in 0..=i {
                let mut sum = dot(&self.scaled[i], &self.scaled[j]);
                if i == j {
                    sum += PROXIMAL;
                }
                for k in 0..j {
                    sum -= self.factor[i][k] * self.factor[j][k];
                }
                self.factor[i][j] = if i == j {
                    // Round-off of BBᵀ may cancel a part of ε, but not more.
                    sum.max(0.1 * PROXIMAL).sqrt()
                } else {
                    sum / self.factor[j][j]
                };
            }
        }
    }

    /// x ← Bᵀ(BBᵀ + εI)⁻¹ x, repeated on the residual as long as it decreases much: a direction with little inertia,
    /// such as the axis of a slender rod, has a small pivot but is not lost.
    #[cold]
    #[inline(never)]
    pub(super) fn solve(&self, x: &mut [f64; K]) {
        let mut rest: [f64; K] = super::array(|i| self.scale[i] * x[i]);
        let mut multiplier = [0.0; K];
        let enough = PASSED * super::largest_of(&rest);
        let mut last = f64::INFINITY;
        for _ in 0..PASSES {
            let change = self.pass(rest);
            for i in 0..K {
                rest[i] -= dot(&self.scaled[i], &change);
            }
            let size = super::largest_of(&rest);
            if !size.is_finite() {
                // Zero multipliers would hide it.
                multiplier = [f64::NAN; K];
                break;
            }
            if !(size < SHRINKS * last) {
                break;
            }
            for i in 0..K {
                multiplier[i] += change[i];
            }
            if size <= enough {
                break;
            }
            last = size;
        }
        *x = super::array(|j| self.scale[j] * multiplier[j]);
    }

    /// One proximal step on scaled rows.
    fn pass(&self, mut x: [f64; K]) -> [f64; K] {
        for i in 0..K {
            for j in 0..i {
                x[i] -= self.factor[i][j] * x[j];
            }
            x[i] /= self.factor[i][i];
        }
        for i in (0..K).rev() {
            for j in i + 1..K {
                x[i] -= self.factor[j][i] * x[j];
            }
            x[i] /= self.factor[i][i];
        }
        let mut result = [0.0; K];
        for i in 0..K {
            for j in 0..K {
                result[j] += self.scaled[i][j] * x[i];
            }
        }
        result
    }
}
