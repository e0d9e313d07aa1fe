//! How far the rows are from losing their independence.

/// Weight of landings so close to a singular pose that the solve there is the proximal one.
const LOST: f64 = 0.01;

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
            LOST * fraction(self.weakest)
        } else {
            0.0
        }
    }
}
