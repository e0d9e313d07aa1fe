//! The multiplier solve of the velocity rows, whose matrix S = A M⁻¹ Aᵀ is symmetric.

use super::proximal::Proximal;
use super::{SPARSE_FROM, Square};
use crate::singular::{REDUNDANT, RankMargin, Thresholds, WEAK_PIVOT, round_off};
use nalgebra::{SMatrix, SVector};

/// S factored as Uᵀ D⁻¹ U while it is well conditioned, the proximal solve S(S² + εI)⁻¹ where it is not.
#[derive(Clone)]
pub(crate) struct DelassusFactor<const K: usize> {
    upper: Square<K>,
    inverse_pivot: [f64; K],
    proximal: Proximal<K>,
    /// Whether the last factorisation is the proximal one.
    pub(crate) regularised: bool,
    /// Whether solutions of the last factorisation lose digits that an iteration on the residual restores.
    pub(crate) weak: bool,
    /// Whether a row has nearly lost its direction: beside a singular pose.
    pub(crate) beside: bool,
    pub(crate) thresholds: Thresholds,
    /// Rows that follow from those before them in all poses so far.
    redundant: Option<[bool; K]>,
    /// Which of them followed in the last factorisation: their multipliers are zero.
    skipped: [bool; K],
    /// Whether there are any.
    pub(crate) reduced: bool,
}

impl<const K: usize> DelassusFactor<K> {
    pub(crate) fn new() -> Self {
        DelassusFactor {
            upper: bytemuck::zeroed_box(),
            inverse_pivot: [0.0; K],
            proximal: Proximal::new(),
            regularised: false,
            weak: false,
            beside: false,
            thresholds: Thresholds::SECOND_ORDER,
            redundant: None,
            skipped: [false; K],
            reduced: false,
        }
    }

    /// Marks the rows that follow from others in `matrix` as redundant: from now on their multipliers are zero, as long
    /// as they still follow from others. (The proximal solve shares the load among rows, which matters to reactions,
    /// not to motion.)
    #[inline(never)]
    pub(crate) fn expect_redundancy(&mut self, matrix: &SMatrix<f64, K, K>) {
        self.redundant = None;
        let found = self.eliminate_but(&[true; K], &matrix.data.0) && self.reduced;
        self.redundant = found.then_some(self.skipped);
        self.factor(matrix);
    }

    /// The smallest relative pivot of `matrix`, without rows that follow from others; 1 at most.
    #[inline(never)]
    pub(crate) fn least_pivot(&mut self, matrix: &SMatrix<f64, K, K>) -> f64 {
        self.expect_redundancy(matrix);
        if self.regularised {
            return 1.0;
        }
        // Redundant rows have no pivot: its inverse is zero.
        let relative = (0..K).map(|k| 1.0 / (self.inverse_pivot[k] * matrix[(k, k)]));
        relative.fold(1.0, f64::min)
    }

    /// Rows that get no multiplier, where there are any.
    #[inline(always)]
    pub(crate) fn skipped(&self) -> Option<&[bool; K]> {
        self.reduced.then_some(&self.skipped)
    }

    /// Factors `matrix`, of which the upper triangle is read; its diagonal is the scale of the pivots.
    #[inline(always)]
    pub(crate) fn factor(&mut self, matrix: &SMatrix<f64, K, K>) {
        let entries = &matrix.data.0;
        let regular = match self.redundant {
            None => self.eliminate(entries),
            Some(redundant) => self.eliminate_but(&redundant, entries),
        };
        self.regularised = !regular;
        if self.regularised {
            (self.weak, self.beside) = (true, self.thresholds.beside > 0.0);
            let diagonal = super::array(|i| entries[i][i]);
            self.proximal.factor(entries, &diagonal);
        }
    }

    #[inline(always)]
    fn eliminate(&mut self, matrix: &[[f64; K]; K]) -> bool {
        self.eliminate_where(|_, _| false, matrix)
    }

    /// The same past rows that still are redundant. Not inlined, so that the compiler unrolls only the other form.
    #[inline(never)]
    fn eliminate_but(&mut self, redundant: &[bool; K], matrix: &[[f64; K]; K]) -> bool {
        let (mut skipped, mut reduced) = ([false; K], false);
        let known = self.redundant.is_some();
        let mut least = 1.0_f64;
        let regular = self.eliminate_where(
            |k, pivot| {
                let length = matrix[k][k];
                if redundant[k] {
                    let most = if known { 1.0 } else { REDUNDANT[1] };
                    let bound = round_off(least).clamp(REDUNDANT[0], most);
                    skipped[k] = pivot.abs() <= bound * length;
                    reduced |= skipped[k];
                }
                if !skipped[k] && pivot < least * length {
                    least = pivot / length;
                }
                skipped[k]
            },
            matrix,
        );
        (self.skipped, self.reduced) = (skipped, reduced && regular);
        regular
    }

    /// False at the first small pivot of a row that is not `passed_over`.
    #[inline(always)]
    fn eliminate_where(
        &mut self,
        mut passed_over: impl FnMut(usize, f64) -> bool,
        matrix: &[[f64; K]; K],
    ) -> bool {
        let mut weak = false;
        let upper = &mut self.upper;
        for i in 0..K {
            for j in i..K {
                upper[i][j] = matrix[i][j];
            }
        }
        for k in 0..K {
            let pivot_row = upper[k];
            let pivot = pivot_row[k];
            if passed_over(k, pivot) {
                self.inverse_pivot[k] = 0.0;
                continue;
            }
            if !(pivot > self.thresholds.lost * matrix[k][k]) {
                return false;
            }
            weak |= pivot < WEAK_PIVOT * matrix[k][k];
            let inverse = 1.0 / pivot;
            self.inverse_pivot[k] = inverse;
            for i in k + 1..K {
                if K >= SPARSE_FROM && pivot_row[i] == 0.0 {
                    continue;
                }
                let factor = pivot_row[i] * inverse;
                for j in i..K {
                    upper[i][j] -= factor * pivot_row[j];
                }
            }
        }
        self.weak = weak;
        self.beside = weak && self.thresholds.beside > 0.0 && self.is_beside(matrix);
        true
    }

    #[cold]
    #[inline(never)]
    fn is_beside(&self, matrix: &[[f64; K]; K]) -> bool {
        (0..K).any(|k| self.inverse_pivot[k] * matrix[k][k] > 1.0 / self.thresholds.beside)
    }

    /// The rank margin of the first `rows` rows of `matrix`, which was factored last.
    #[inline]
    pub(crate) fn rank_margin(&mut self, matrix: &SMatrix<f64, K, K>, rows: usize) -> RankMargin {
        let matrix = &matrix.data.0;
        if self.regularised {
            return self.dependence(matrix, rows);
        }
        let mut most: f64 = 0.0;
        for k in 0..rows {
            most = most.max(self.inverse_pivot[k] * matrix[k][k]);
        }
        RankMargin::of(1.0 / most.sqrt())
    }

    /// Eliminates past rows without a direction of their own. The proximal solve does not need the room this takes.
    #[cold]
    #[inline(never)]
    fn dependence(&mut self, matrix: &[[f64; K]; K], rows: usize) -> RankMargin {
        let upper = &mut self.upper;
        **upper = *matrix;
        let (mut least, mut weakest) = (f64::INFINITY, f64::INFINITY);
        let (mut lost, mut dependent, mut sigma) = (0, 0, f64::INFINITY);
        for k in 0..rows {
            let pivot_row = upper[k];
            let pivot = pivot_row[k];
            let relative = pivot / matrix[k][k];
            weakest = weakest.min(relative.max(0.0));
            if relative > self.thresholds.lost {
                sigma = sigma.min(relative);
            } else {
                lost += 1;
            }
            if !(relative > round_off(least)) {
                dependent += 1;
                continue;
            }
            least = least.min(relative);
            for i in k + 1..rows {
                let factor = pivot_row[i] / pivot;
                for j in i..rows {
                    upper[i][j] -= factor * pivot_row[j];
                }
            }
        }
        RankMargin {
            sigma: sigma.sqrt(),
            weakest: weakest.sqrt(),
            lost,
            least: least.sqrt(),
            dependent,
        }
    }

    /// The combination of the first `rows` rows, each of unit length, that is nearest to zero, estimated from the
    /// smallest pivot. Call [`Self::independence`] with the same matrix before.
    #[cold]
    #[inline(never)]
    pub(crate) fn combination(&self, matrix: &SMatrix<f64, K, K>, rows: usize) -> SVector<f64, K> {
        let matrix = &matrix.data.0;
        let mut combination = [0.0; K];
        let (mut weakest, mut least) = (None, f64::INFINITY);
        let counts: [bool; K] = super::array(|k| {
            let relative = self.upper[k][k] / matrix[k][k];
            let counts = k < rows && relative > round_off(least);
            if counts && relative < least {
                (weakest, least) = (Some(k), relative);
            }
            counts
        });
        let Some(weakest) = weakest else {
            return combination.into();
        };
        combination[weakest] = 1.0;
        for i in (0..weakest).rev().filter(|&i| counts[i]) {
            let mut sum = 0.0;
            for j in i + 1..=weakest {
                sum += self.upper[i][j] * combination[j];
            }
            combination[i] = -sum / self.upper[i][i];
        }
        super::vector(|i| combination[i] * matrix[i][i].max(0.0).sqrt())
    }

    /// x ← S⁻¹ x, or x ← S(S² + εI)⁻¹ x on rows of unit length.
    #[inline(always)]
    pub(crate) fn solve(&self, x: &mut SVector<f64, K>) {
        let [x] = &mut x.data.0;
        if self.regularised {
            return self.proximal.solve(x);
        }
        for k in 0..K {
            let factor = x[k] * self.inverse_pivot[k];
            for j in k + 1..K {
                x[j] -= factor * self.upper[k][j];
            }
        }
        for k in (0..K).rev() {
            let mut sum = x[k];
            for j in k + 1..K {
                sum -= self.upper[k][j] * x[j];
            }
            x[k] = sum * self.inverse_pivot[k];
        }
    }
}
