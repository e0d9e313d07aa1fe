//! What decides about singular poses, lost rows and round-off.
//!
//! One measure of independence: the pivots of S = A M⁻¹Aᵀ, each relative to a M⁻¹aᵀ of its row. Such a pivot is σ², where
//! σ is the part of a row, taken with unit length, that no row before it has. At a singular pose σ falls linearly to zero.
//!
//! | σ² | what it means |
//! |---|---|
//! | up to [`Thresholds::lost`] | the row has lost its direction: the proximal solve |
//! | up to [`Thresholds::beside`] | beside a singular pose: what is left of φ turns velocities by φ/σ², and is closed to [`EXACT`] |
//! | up to [`WEAK_PIVOT`] | solutions lose digits, which an iteration on the residual restores |
//!
//! Residuals are sums of squares (φ_i/tolerance_i)², so that 1 is the tolerance.
//!
//! Where steps land beside a pose is in `stage_placement.rs` and `simulation/placement.rs`, which poses are reported in
//! `simulation/singularity_detector.rs`. Each constant that was chosen and not derived says what it trades.

/// ε of the proximal solve on rows of unit length: 1/ξ² for the penalty ξ = 1e7 of the augmented Lagrangian. Smaller, and
/// round-off of BBᵀ takes its place; larger, and weak rows need more passes.
pub(crate) const PROXIMAL: f64 = 1e-14;
/// Most proximal steps of a solve: time against digits of weak directions. Bounds the known cost of a step.
pub(crate) const PASSES: usize = 16;
/// A proximal step that leaves more than this part of what the one before left has come to the lost directions: weak ones,
/// such as the axis of a slender rod, against time. (With 1/2, as elsewhere, such a rod stays open.)
pub(crate) const SHRINKS: f64 = 0.7;
/// What is left below this part of the whole is left to the iteration around: passes against refinements.
pub(crate) const PASSED: f64 = 1e-6;

/// A pivot below this fraction calls for an iteration on the residual: of 16 digits 13 are left.
pub(crate) const WEAK_PIVOT: f64 = 1e-3;

/// A squared residual above this part of the last one has stalled: corrections that do not halve an error end at round-off
/// or in a lost direction. Larger, and they are repeated in vain; smaller, and slow ones are taken for finished.
pub(crate) const STALLED: f64 = 0.25;
/// The same of sizes that are not squared.
#[inline(always)]
pub(crate) fn has_stalled(size: f64, last: f64) -> bool {
    size * size >= STALLED * (last * last)
}
/// A stalled residual is taken for round-off up to this many squared tolerances, a thousand tolerances: rows are long
/// beside the round-off of their terms in some mechanisms.
pub(crate) const STAGNATED: f64 = 1e6;
/// What is left of φ beside a singular pose, in squared tolerances: there it turns velocities by φ/σ². Digits beside poses
/// against an iteration more.
pub(crate) const EXACT: f64 = 1e-6;
/// A displacement, relative to the size of the mechanism, that a row may keep for one step when that step begins or ends
/// so close to a singular pose that its multiplier has no direction; the next step closes it. A lost step against a jump
/// of the position.
pub(crate) const LEFT_OPEN: f64 = 1e-6;

/// Velocities are known up to this part of them: some tens of units in the last place.
pub(crate) const ROUND_OFF: f64 = 1e-14;
/// Corrections of velocities that stall below this part of them are round-off, of forces much larger than their sum.
pub(crate) const STILL: f64 = 1e-9;
/// What squares to round-off: a row that adds less than this part of its length to others, or that is shorter by this
/// than its unit leads to expect, says nothing.
pub(crate) const NOTHING: f64 = 1e-8;

/// A pivot below this part of its row's own length is round-off: the row depends on others.
pub const DEPENDENT: f64 = 1e-11;

/// A relative pivot of a row that follows from those before it is round-off over the smallest pivot of others; at least and,
/// where it is yet to be found out which rows these are, at most this. Independent rows may be as weak as that.
pub(crate) const REDUNDANT: [f64; 2] = [1e-10, 1e-8];

/// A relative pivot that is round-off, after the `least` one so far, by which errors were divided.
pub(crate) fn round_off(least: f64) -> f64 {
    (16.0 * f64::EPSILON / least).max(DEPENDENT)
}

/// Below this ratio of the smallest pivots of A₁J⁻¹½(A₀ + A₁)ᵀ and A₁J⁻¹A₁ᵀ the mean direction of an implicit step counts
/// as lost: accuracy of a damped step over a singular pose, which is left to the kicks, against that of one beside it.
pub(crate) const MEAN_LOST: f64 = 0.3;

/// Multipliers whose squares grow by more than this in a step are not kept for the next one; a step beside a singular pose
/// can have huge ones along a direction that does nothing there. Iterations against leaving the branch of the motion.
pub(crate) const USUAL_GROWTH: f64 = 100.0;
/// The same for a step beside a singular pose.
pub(crate) const USUAL_GROWTH_WEAK: f64 = 4.0;

/// What a factorisation goes by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Thresholds {
    /// A row with a smaller pivot has lost its direction.
    pub(crate) lost: f64,
    /// Rows with a smaller pivot are closed to [`EXACT`].
    pub(crate) beside: f64,
}

/// A row with a smaller pivot has lost its direction, unless steps are placed: digits beside a pose against branches.
///
/// Slider-crank and double four-bar through their poses, orders 2 to 8, 160 steps from 0.5 to 20 ms each, not placed: with
/// 1.5e-8 the mean error of energy of orders 6 and 8 is smaller by 1.6 decades, and one run of 1280 ends on another branch
/// of the motion; with 1e-6 none. At second order the two are the same.
const LOST: f64 = 1e-6;
/// The same where steps are placed: they land close to a pose only where short stages leave no other choice, and then as
/// exactly as multipliers allow. Digits against the proximal solve, which is safe.
///
/// On the runs above, placed, the mean error of order 8 is the same from 1e-8 to 1e-11, and 1.3 decades larger with 1e-7.
/// √u = 1.5e-8 would do there, but not at steps of 0.55 ms that end at given instants: 9e-9 J in place of 1e-10 J
/// (`tests/tests/passages.rs`).
const LOST_IF_PLACED: f64 = 1e-9;
/// A pivot below this part of its usual size belongs to a place beside a singular pose: bodies with little inertia about
/// an axis make rows weak everywhere, and would be closed to [`EXACT`] at every step.
const UNUSUAL: f64 = 0.1;

impl Thresholds {
    /// For steps of second order, whose own error is larger than what they lose here: closing rows more tightly beside a
    /// pose took 1 % more iterations and changed no error by 1 %.
    pub(crate) const SECOND_ORDER: Self = Thresholds {
        lost: LOST,
        beside: 0.0,
    };

    /// For steps of higher order, where the smallest pivot at the declared guess is `usual`.
    ///
    /// One admissible error e of velocities for both levels, lost below u/e and beside below tolerance/e, was tried: with
    /// lost at 1.5e-8 rows are closed tightly below 7e-6 only. With 1e-5 in place of [`WEAK_PIVOT`] the mean error of order
    /// 8 on the double four-bar grows from 7e-12 J to 2e-11 J.
    pub(crate) fn high_order(usual: f64, placed: bool) -> Self {
        Thresholds {
            lost: if placed { LOST_IF_PLACED } else { LOST },
            beside: WEAK_PIVOT.min(UNUSUAL * usual),
        }
    }
}

/// Weight of landings so close to a singular pose that the solve there is the proximal one: any other is better.
const PROXIMAL_LANDING: f64 = 0.01;

/// σ before a landing of which too little is left to tell of a singular pose, when it passes the mark of the lost.
const FALLS_FROM: f64 = 3e-3;

/// A cheap estimate of the smallest singular value of the rows, each of unit length, from the pivots of S.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RankMargin {
    /// √ of the smallest relative pivot; of those rows that have a direction of their own.
    pub(crate) sigma: f64,
    /// √ of the smallest relative pivot of all rows.
    pub(crate) weakest: f64,
    /// How many rows call for the proximal solve.
    pub(crate) lost: usize,
    /// The same as `sigma` and `lost`, where only round-off counts as lost: bodies with little inertia about an axis make
    /// rows weak that are independent.
    pub(crate) least: f64,
    pub(crate) dependent: usize,
}

impl RankMargin {
    /// Rows at right angles.
    pub(crate) const FULL: Self = Self::of(1.0);

    /// Rows none of which is lost.
    pub(crate) const fn of(sigma: f64) -> Self {
        RankMargin {
            sigma,
            weakest: sigma,
            lost: 0,
            least: sigma,
            dependent: 0,
        }
    }

    /// σ₁/(σ₀ + σ₁) for a landing here after `before`: σ falls linearly to zero at a singular pose, and rises again
    /// behind it, so that this is the distance of the landing from the pose as a fraction of the way.
    ///
    /// Rows that are redundant at both ends do not count; a landing where more rows are lost is worse than any other.
    pub(crate) fn after(&self, before: &Self) -> f64 {
        if !before.sigma.is_finite() {
            return f64::INFINITY;
        }
        let fraction = |sigma: f64| sigma / (sigma + before.sigma);
        if self.lost < before.lost || (self.lost > before.lost && before.sigma < FALLS_FROM) {
            // A row that is always weak has passed the mark.
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
