//! The bounds for singular poses, lost rows and round-off, and the rank margin.
//!
//! The pivots of S = A M⁻¹Aᵀ, each relative to a M⁻¹aᵀ of its row, measure the independence of the rows. Such a pivot
//! is σ², where σ is the length of the part of a row, scaled to unit length, that is orthogonal to all rows before it.
//! A row that is shorter than at the declared guess is scaled by its length there: in joint coordinates a row can vanish
//! as a whole at a singular pose.
//! Towards a singular pose σ decreases linearly to zero.
//!
//! | σ² | meaning |
//! |---|---|
//! | up to [`Thresholds::lost`] | the row has lost its direction: the proximal solve |
//! | up to [`Thresholds::beside`] | beside a singular pose: the residual φ turns velocities by φ/σ², and is reduced to [`EXACT`] |
//! | up to [`WEAK_PIVOT`] | solutions lose digits, which an iteration on the residual restores |
//!
//! Residuals are sums of squares (φ_i/tolerance_i)², so that 1 is the tolerance.
//!
//! The lengths of steps beside a pose are chosen in `stage_placement.rs` and `simulation/placement.rs`; the poses to be
//! reported are found in `simulation/singularity_detector.rs`. For each constant that was chosen, not derived, the
//! trade-off is stated.

/// ε of the proximal solve on rows of unit length: 1/ξ² for the penalty ξ = 1e7 of the augmented Lagrangian. If it is
/// smaller, round-off of BBᵀ exceeds it; if it is larger, rows with small pivots need more passes.
pub(crate) const PROXIMAL: f64 = 1e-14;
/// The maximum number of proximal steps of a solve: more of them take time, fewer lose digits in directions with small
/// pivots. It enters the bound of the cost of a step.
pub(crate) const PASSES: usize = 16;
/// If a proximal step leaves more than this fraction of the residual of the one before, the rest is in lost directions.
/// A larger value resolves directions with smaller pivots, such as the axis of a slender rod, and takes time. (With
/// 1/2, as elsewhere, the rows of such a rod are not satisfied.)
pub(crate) const SHRINKS: f64 = 0.7;
/// A residual below this fraction of the right-hand side is left to the outer iteration: a smaller value takes more
/// passes, a larger one more corrections there.
pub(crate) const PASSED: f64 = 1e-6;

/// Below this relative pivot the solution needs an iteration on the residual: of 16 digits 13 are left.
pub(crate) const WEAK_PIVOT: f64 = 1e-3;

/// A squared residual above this fraction of the last one has stalled: if a correction does not halve the error, the
/// rest is round-off or in a lost direction. With a larger value corrections are repeated without effect; with a
/// smaller one slow convergence counts as stalled.
pub(crate) const STALLED: f64 = 0.25;
/// The same for sizes that are not squared.
#[inline(always)]
pub(crate) fn has_stalled(size: f64, last: f64) -> bool {
    size * size >= STALLED * (last * last)
}
/// A stalled residual counts as round-off up to this many squared tolerances, a thousand tolerances: rows are long
/// beside the round-off of their terms in some mechanisms.
pub(crate) const STAGNATED: f64 = 1e6;
/// The residual of φ to reach beside a singular pose, in squared tolerances: there φ turns velocities by φ/σ². A
/// smaller value gains digits beside poses and takes another iteration.
pub(crate) const EXACT: f64 = 1e-6;
/// The residual of a position row, as a displacement relative to the size of the mechanism, that is accepted for one
/// step if the step begins or ends so close to a singular pose that the row has no multiplier; the next step removes
/// it. With a smaller value steps fail, with a larger one the position jumps.
pub(crate) const LEFT_OPEN: f64 = 1e-6;

/// The relative round-off of velocities: some tens of units in the last place.
pub(crate) const ROUND_OFF: f64 = 1e-14;
/// Corrections of velocities that stall below this fraction of the velocities are round-off, of forces much larger than
/// their sum.
pub(crate) const STILL: f64 = 1e-9;
/// Its square is round-off: a row counts as zero if it adds less than this fraction of its length to others, or if its
/// length is below this fraction of the length that is expected from its unit.
pub(crate) const NOTHING: f64 = 1e-8;

/// A pivot below this fraction of the diagonal entry of its row is round-off: the row depends on others.
pub const DEPENDENT: f64 = 1e-11;

/// The relative pivot of a row that follows from those before it is round-off divided by the smallest pivot of the
/// others. It is taken as at least the first value and, while these rows are not known yet, at most the second.
/// Independent rows may have pivots as small as that.
pub(crate) const REDUNDANT: [f64; 2] = [1e-10, 1e-8];

/// The same in the stages of explicit steps, which violate the rows: by less than a hundredth in any step that is not
/// much too long, and pivots are squares. With a smaller value redundant rows are asked for in coarse steps.
pub(crate) const REDUNDANT_OFF_ROWS: f64 = 1e-4;

/// The bound below which a relative pivot is round-off; `least` is the smallest pivot so far, by which errors were
/// divided.
pub(crate) fn round_off(least: f64) -> f64 {
    (16.0 * f64::EPSILON / least).max(DEPENDENT)
}

/// Below this ratio of the smallest pivots of A₁J⁻¹½(A₀ + A₁)ᵀ and A₁J⁻¹A₁ᵀ the mean direction of an implicit step
/// counts as lost, and the step is taken with kicks. The value balances the accuracy of damped steps through a singular
/// pose against that of steps beside it.
pub(crate) const MEAN_LOST: f64 = 0.3;

/// Multipliers whose squares grow by more than this in a step are not kept for the next one: a step beside a singular
/// pose can have very large ones along a direction that has no effect there. A smaller value takes more iterations;
/// with a larger one the motion may change its branch.
pub(crate) const USUAL_GROWTH: f64 = 100.0;
/// The same for a step beside a singular pose.
pub(crate) const USUAL_GROWTH_WEAK: f64 = 4.0;

/// The bounds of a factorisation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Thresholds {
    /// A row with a smaller pivot has lost its direction.
    pub(crate) lost: f64,
    /// Rows with a smaller pivot are solved to [`EXACT`].
    pub(crate) beside: f64,
}

/// A row with a smaller pivot has lost its direction, without placement: a smaller value gains digits beside a pose, a
/// larger one avoids changes of the branch.
///
/// Slider-crank and double four-bar through their poses, orders 2 to 8, 160 steps from 0.5 to 20 ms each, without
/// placement: with 1.5e-8 the mean error of energy of orders 6 and 8 is smaller by 1.6 decades, and one run of 1280
/// ends on another branch of the motion; with 1e-6 none. At second order the two are the same.
const LOST: f64 = 1e-6;
/// The same with placement: a stage ends close to a pose only if the short stages make this unavoidable, and its rows
/// are then solved as accurately as possible. A smaller value gains digits; with a larger one the proximal solve, which
/// is safe, is used more often.
///
/// In the runs above, with placement, the mean error of order 8 is the same from 1e-8 to 1e-11, and 1.3 decades larger
/// with 1e-7. √u = 1.5e-8 would be enough there, but not for steps of 0.55 ms that end at given instants: 9e-9 J
/// instead of 1e-10 J (`tests/tests/passages.rs`).
const LOST_IF_PLACED: f64 = 1e-9;
/// A pivot below this fraction of its usual size shows that a singular pose is near. Bodies with little inertia about
/// an axis have rows with small pivots in every pose; without this factor such rows would be solved to [`EXACT`] in
/// every step.
pub(crate) const UNUSUAL: f64 = 0.1;

impl Thresholds {
    /// For steps of second order without placement. Their error is larger than the loss of digits beside a pose: solving
    /// rows more accurately there took 1 % more iterations and changed no error by 1 %.
    pub(crate) const SECOND_ORDER: Self = Thresholds {
        lost: LOST,
        beside: 0.0,
    };
    /// The same with placement: velocity rows keep residuals of 1e-8 instead of 1e-6 beside a pose, position rows their
    /// tolerance, and a sixth of the steps is placed. Errors of energy and branches are the same.
    pub(crate) const SECOND_ORDER_PLACED: Self = Thresholds {
        lost: LOST_IF_PLACED,
        beside: 0.0,
    };

    /// For explicit steps with an elimination of K (`baselines/planned.rs`): rows are eliminated as long as they have a pivot.
    /// A correction by what is left of the rows restores the digits that weak ones lose. Beside the pose of ten four-bar
    /// loops accelerations have errors of 1e-15 where σ² is about 1e-8, and of 2e-13 at about 1e-10.
    ///
    /// Rows of many loops lose their directions together, and the smallest eigenvalue of S is far below the smallest pivot.
    /// The proximal solve, whose ε hides eigenvalues up to 1e-7, then errs by a hundredth at σ = 1e-3 already. Of 306 runs of
    /// order 8 with 80 to 1400 constant steps in ten seconds, without placement, with ten and forty loops, 111 end on another
    /// branch with [`LOST`], and 4 with this value.
    pub(crate) const ELIMINATED: Self = Thresholds {
        lost: DEPENDENT,
        beside: 0.0,
    };

    /// For steps of higher order, where the smallest pivot at the declared guess is `usual`.
    ///
    /// A single admissible error e of velocities for both bounds, `lost` = u/e and `beside` = tolerance/e, was tried:
    /// with `lost` = 1.5e-8 rows are solved more accurately only below 7e-6. With 1e-5 instead of [`WEAK_PIVOT`] the
    /// mean error of order 8 on the double four-bar grows from 7e-12 J to 2e-11 J.
    pub(crate) fn high_order(usual: f64, placed: bool) -> Self {
        Thresholds {
            lost: if placed { LOST_IF_PLACED } else { LOST },
            beside: WEAK_PIVOT.min(UNUSUAL * usual),
        }
    }
}

/// Weight of the clearance if the step ends so close to a singular pose that the proximal solve is used: any other end
/// is better.
const PROXIMAL_LANDING: f64 = 0.01;

/// If σ before the step was below this multiple of the bound at which a row counts as lost, and one is lost after it, its
/// pivot is always small: this is not a singular pose.
const FALLS_FROM: f64 = 3.0;

/// Added to [`RankMargin::dependent`] where other redundant rows are left out than usual.
pub(crate) const OTHER_ROWS: u32 = 1 << 31;

/// A cheap estimate of the smallest singular value of the rows, each of unit length, from the pivots of S.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RankMargin {
    /// √ of the smallest relative pivot of the rows that are not lost.
    pub(crate) sigma: f64,
    /// √ of the smallest relative pivot of all rows.
    pub(crate) weakest: f64,
    /// The number of rows that need the proximal solve …
    pub(crate) lost: u32,
    /// … and √ of the bound of their pivots, if there are any.
    pub(crate) bound: f64,
    /// The same as `sigma` and `lost`, if only round-off counts as lost: for bodies with little inertia about an axis,
    /// independent rows can have small pivots.
    pub(crate) least: f64,
    pub(crate) dependent: u32,
}

impl RankMargin {
    /// Rows at right angles.
    pub(crate) const FULL: Self = Self::of(1.0);

    /// No row is lost.
    pub(crate) const fn of(sigma: f64) -> Self {
        RankMargin {
            sigma,
            weakest: sigma,
            lost: 0,
            bound: 0.0,
            least: sigma,
            dependent: 0,
        }
    }

    /// σ of the rows that are not lost at `other`, an instant near to this one.
    pub(crate) fn beside(&self, other: &Self) -> f64 {
        match self.lost > other.lost {
            true => self.weakest,
            false => self.sigma,
        }
    }

    /// Whether the choice of the redundant rows that are left out differs from that with this [`Self::dependent`]: σ of
    /// the two cannot be compared.
    #[inline(always)]
    pub(crate) fn is_of_others(&self, dependent: u32) -> bool {
        (self.dependent ^ dependent) & OTHER_ROWS != 0
    }

    /// σ₁/(σ₀ + σ₁) for a step from `before` to here: σ decreases linearly to zero at a singular pose and increases
    /// again after it, so that this is the distance of the end from the pose as a fraction of the step.
    ///
    /// Rows that are redundant at both ends do not count; an end at which more rows are lost is worse than any other.
    pub(crate) fn after(&self, before: &Self) -> f64 {
        if !before.sigma.is_finite() || self.is_of_others(before.dependent) {
            return f64::INFINITY;
        }
        let fraction = |sigma: f64| sigma / (sigma + before.sigma);
        if self.lost < before.lost
            || (self.lost > before.lost && before.sigma < FALLS_FROM * self.bound)
        {
            // The pivot of a row that is always small has crossed the bound.
            0.5
        } else if self.lost == before.lost {
            fraction(self.sigma)
        } else if before.lost == 0 {
            PROXIMAL_LANDING * fraction(self.weakest)
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::RankMargin;

    fn lost(bound: f64) -> RankMargin {
        RankMargin {
            sigma: 0.1,
            weakest: 0.1 * bound,
            lost: 1,
            bound,
            least: 0.1 * bound,
            dependent: 0,
        }
    }

    #[test]
    fn rows_that_fall_are_told_from_rows_that_are_always_weak() {
        for bound in [3e-5, 1e-3] {
            assert!(lost(bound).after(&RankMargin::of(30.0 * bound)) < 0.01);
            assert_eq!(lost(bound).after(&RankMargin::of(2.0 * bound)), 0.5);
        }
    }
}
