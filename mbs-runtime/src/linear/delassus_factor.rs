//! The multiplier solve of the velocity rows, whose matrix S = A M⁻¹ Aᵀ is symmetric.

use super::kept_rows::dependent_rows;
use super::proximal::Proximal;
use super::{SPARSE_FROM, Square, larger};
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::singular::{
    OTHER_ROWS, REDUNDANT, RankMargin, Thresholds, UNUSUAL, WEAK_PIVOT, round_off,
};
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
    /// The usual a M⁻¹aᵀ of each row. A row can vanish as a whole at a singular pose, where its own length is no scale.
    pub(crate) usual: SVector<f64, K>,
    /// Rows that follow from those before them in all poses so far.
    redundant: Option<[bool; K]>,
    /// A row that is redundant in general follows from the others if its relative pivot is below this.
    pub(crate) follows: f64,
    /// Which of them followed in the last factorisation: their multipliers are zero.
    skipped: [bool; K],
    /// Whether there are any.
    pub(crate) reduced: bool,
    /// [`OTHER_ROWS`] if other rows are left out than those that are redundant in general, or 0.
    choice: u32,
    /// A relative pivot below this shows that a singular pose is near, or that other rows have to be left out.
    unusual: f64,
}

impl<const K: usize> DelassusFactor<K> {
    pub(crate) fn new() -> Self {
        DelassusFactor {
            upper: Square::zeros(),
            inverse_pivot: [0.0; K],
            proximal: Proximal::new(),
            regularised: false,
            weak: false,
            beside: false,
            thresholds: Thresholds::SECOND_ORDER,
            usual: SVector::zeros(),
            redundant: None,
            follows: REDUNDANT[0],
            skipped: [false; K],
            reduced: false,
            choice: 0,
            unusual: 0.0,
        }
    }

    /// Marks the rows that follow from others in `matrix` as redundant: from now on their multipliers are zero, as long
    /// as they still follow from others. (The proximal solve shares the load among rows, which matters to reactions,
    /// not to motion.)
    #[inline(never)]
    pub(crate) fn expect_redundancy(&mut self, matrix: &SMatrix<f64, K, K>) {
        self.redundant = None;
        let (regular, _) = self.eliminate_but(&[true; K], &matrix.data.0);
        let found = regular && self.reduced;
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

    /// Learns from the matrix at the declared guess how small pivots usually are, if there are redundant rows.
    #[inline(never)]
    pub(crate) fn expect_pivots(&mut self, matrix: &SMatrix<f64, K, K>) {
        let Some(redundant) = self.redundant else {
            return;
        };
        let mut least = 1.0_f64;
        self.eliminate_where(
            |k, pivot, length| {
                if !redundant[k] {
                    least = least.min(pivot / length);
                }
                redundant[k]
            },
            &matrix.data.0,
        );
        self.unusual = UNUSUAL * least;
    }

    /// Whether rows follow from others in all poses so far.
    #[inline(always)]
    pub(crate) fn has_redundant(&self) -> bool {
        self.redundant.is_some()
    }

    /// Rows that get no multiplier, where there are any.
    #[inline(always)]
    pub(crate) fn skipped(&self) -> Option<&[bool; K]> {
        self.reduced.then_some(&self.skipped)
    }

    /// What a pivot of this row counts relative to.
    #[inline(always)]
    fn scale(&self, matrix: &[[f64; K]; K], k: usize) -> f64 {
        larger(matrix[k][k], self.usual[k])
    }

    /// Factors `matrix`, of which the upper triangle is read; its diagonal is the scale of the pivots, unless a row is
    /// shorter than usual.
    #[inline(always)]
    pub(crate) fn factor(&mut self, matrix: &SMatrix<f64, K, K>) {
        let entries = &matrix.data.0;
        let regular = match self.redundant {
            None => self.eliminate(entries),
            Some(redundant) => {
                self.choice = 0;
                let (regular, least) = self.eliminate_but(&redundant, entries);
                match least < self.unusual {
                    true => self.eliminate_others(&redundant, entries, (regular, least)),
                    false => regular,
                }
            }
        };
        self.regularised = !regular;
        if self.regularised {
            (self.weak, self.beside) = (true, self.thresholds.beside > 0.0);
            let scales = super::array(|i| self.scale(entries, i));
            self.proximal.factor(entries, &scales);
        }
    }

    #[inline(always)]
    fn eliminate(&mut self, matrix: &[[f64; K]; K]) -> bool {
        self.eliminate_where(|_, _, _| false, matrix)
    }

    /// The same past rows that still are redundant, and the smallest relative pivot of the others. Not inlined, so that the
    /// compiler unrolls only the other form.
    #[inline(never)]
    fn eliminate_but(&mut self, redundant: &[bool; K], matrix: &[[f64; K]; K]) -> (bool, f64) {
        let (mut skipped, mut reduced) = ([false; K], false);
        let (known, follows) = (self.redundant.is_some(), self.follows);
        let mut least = 1.0_f64;
        let regular = self.eliminate_where(
            |k, pivot, length| {
                if redundant[k] {
                    let bound = match known {
                        true => round_off(least).max(follows),
                        false => round_off(least).clamp(REDUNDANT[0], REDUNDANT[1]),
                    };
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
        (regular, least)
    }

    /// Whether the rows that are kept in general lose a direction where the largest 1/pivot of them, relative, is this.
    #[inline(always)]
    pub(crate) fn needs_other_rows(&self, most: f64) -> bool {
        most * self.unusual > 1.0
    }

    /// Elimination past other rows than those that are redundant in general: beside a pose where the rows that are kept
    /// there lose a direction which the rows that follow from them still have. (It is not a singular pose. The choice
    /// depends on the pose alone, so that a resumed run makes it, too.) `regular` if there is none.
    #[cold]
    #[inline(never)]
    fn eliminate_others(
        &mut self,
        redundant: &[bool; K],
        matrix: &[[f64; K]; K],
        (regular, least): (bool, f64),
    ) -> bool {
        let count = redundant.iter().filter(|&&redundant| redundant).count();
        let scales = super::array(|k| self.scale(matrix, k));
        self.upper.copy_from_slice(matrix);
        let bounds = [least, self.follows];
        let Some(spare) = dependent_rows(&mut self.upper, &scales, count, bounds) else {
            // The search has used the room of the factor.
            return regular && self.eliminate_but(redundant, matrix).0;
        };
        (self.skipped, self.reduced, self.choice) = (spare, true, OTHER_ROWS);
        self.eliminate_where(|k, _, _| spare[k], matrix)
    }

    /// False at the first small pivot of a row that is not `passed_over`.
    #[inline(always)]
    fn eliminate_where(
        &mut self,
        mut passed_over: impl FnMut(usize, f64, f64) -> bool,
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
            let (pivot, length) = (pivot_row[k], larger(matrix[k][k], self.usual[k]));
            if passed_over(k, pivot, length) {
                self.inverse_pivot[k] = 0.0;
                continue;
            }
            // A row of zeros has no pivot, and no length.
            if !(pivot > WEAK_PIVOT * length) {
                weak = true;
                if !(pivot > self.thresholds.lost * length) {
                    return false;
                }
            }
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
        (0..K).any(|k| self.inverse_pivot[k] * self.scale(matrix, k) > 1.0 / self.thresholds.beside)
    }

    /// The rank margin of the first `rows` rows of `matrix`, which was factored last.
    #[inline]
    pub(crate) fn rank_margin(&mut self, matrix: &SMatrix<f64, K, K>, rows: usize) -> RankMargin {
        let matrix = &matrix.data.0;
        if self.regularised {
            return self.dependence(matrix, rows);
        }
        if self.redundant.is_some() || self.reduced {
            return self.margin_without_skipped(matrix, rows);
        }
        RankMargin {
            dependent: self.choice,
            ..self.margin_of_pivots(matrix, rows)
        }
    }

    #[inline(always)]
    fn margin_of_pivots(&self, matrix: &[[f64; K]; K], rows: usize) -> RankMargin {
        let mut most: f64 = 0.0;
        for k in 0..rows {
            most = most.max(self.inverse_pivot[k] * self.scale(matrix, k));
        }
        RankMargin::of(1.0 / most.sqrt())
    }

    /// The same where rows are left out, or have been.
    #[inline(never)]
    fn margin_without_skipped(&mut self, matrix: &[[f64; K]; K], rows: usize) -> RankMargin {
        if self.redundant.is_some() {
            self.reconsider_redundancy(matrix);
        }
        let skipped = match self.reduced {
            true => self.skipped[..rows].iter().filter(|&&row| row).count() as u32,
            false => 0,
        };
        RankMargin {
            dependent: skipped | self.choice,
            ..self.margin_of_pivots(matrix, rows)
        }
    }

    /// Where all pivots are large, a row that has one does not follow from the others: if it was taken as redundant, the run
    /// has begun in a singular pose. From now on it counts like the others, so that the next such pose is noticed.
    #[cold]
    #[inline(never)]
    fn reconsider_redundancy(&mut self, matrix: &[[f64; K]; K]) {
        let Some(mut redundant) = self.redundant else {
            return;
        };
        let found = |k: usize| redundant[k] && !self.skipped[k];
        if self.weak || self.choice != 0 || !(0..K).any(found) {
            return;
        }
        let mut least = 1.0_f64;
        for k in 0..K {
            redundant[k] &= self.skipped[k];
            if !self.skipped[k] {
                least = least.min(1.0 / (self.inverse_pivot[k] * self.scale(matrix, k)));
            }
        }
        self.redundant = redundant.contains(&true).then_some(redundant);
        self.unusual = UNUSUAL * least;
    }

    /// Eliminates past rows without a direction of their own. The proximal solve does not need the room this takes.
    #[cold]
    #[inline(never)]
    fn dependence(&mut self, matrix: &[[f64; K]; K], rows: usize) -> RankMargin {
        let scales: [f64; K] = super::array(|k| self.scale(matrix, k));
        let upper = &mut self.upper;
        upper.copy_from_slice(matrix);
        let (mut least, mut weakest) = (f64::INFINITY, f64::INFINITY);
        let (mut lost, mut dependent, mut sigma) = (0, 0, f64::INFINITY);
        for k in 0..rows {
            let pivot_row = upper[k];
            let pivot = pivot_row[k];
            let relative = pivot / scales[k];
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
            bound: self.thresholds.lost.sqrt(),
            least: least.sqrt(),
            dependent: dependent | self.choice,
        }
    }

    /// The combination of the first `rows` rows, each of unit length, that is nearest to zero, estimated from the
    /// smallest pivot. Call [`Self::rank_margin`] with the same matrix before.
    #[cold]
    #[inline(never)]
    pub(crate) fn combination(&self, matrix: &SMatrix<f64, K, K>, rows: usize) -> SVector<f64, K> {
        let matrix = &matrix.data.0;
        let mut combination = [0.0; K];
        let (mut weakest, mut least) = (None, f64::INFINITY);
        let counts: [bool; K] = super::array(|k| {
            let relative = self.upper[k][k] / self.scale(matrix, k);
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
        super::vector(|i| combination[i] * self.scale(matrix, i).max(0.0).sqrt())
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
