//! Pivots of S at which rows are treated in another way, each relative to the length of its row: a pivot is σ² there.

/// A pivot below this part of its usual size belongs to a place beside a singular pose.
const UNUSUAL: f64 = 0.1;

/// What a factorisation goes by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Thresholds {
    /// A row with a smaller pivot has lost its direction.
    pub(crate) lost: f64,
    /// Rows with a smaller pivot are closed to round-off: what is left of φ turns velocities by φ/σ².
    pub(crate) beside: f64,
}

impl Thresholds {
    /// For steps of second order, whose own error is larger than what they lose here. (The proximal ε acts on singular
    /// values of about 1e-7.)
    pub(crate) const SECOND_ORDER: Self = Thresholds {
        lost: 1e-6,
        beside: 0.0,
    };

    /// For steps of higher order, where the smallest pivot at the declared guess is `usual`: bodies with little inertia about
    /// an axis make rows weak everywhere.
    ///
    /// Steps that are `placed` land close to a pose only where short stages leave no other choice, and then as exactly as
    /// multipliers allow. Others may land so close that an iteration could choose another branch of the motion: a row that
    /// is left out cannot.
    pub(crate) fn high_order(usual: f64, placed: bool) -> Self {
        Thresholds {
            lost: if placed { 1e-9 } else { 1e-6 },
            beside: super::WEAK_PIVOT.min(UNUSUAL * usual),
        }
    }
}
