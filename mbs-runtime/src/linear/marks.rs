//! Pivots of S at which rows are treated in another way, each relative to the length of its row: a pivot is σ² there.

/// A pivot below this part of its usual size belongs to a place beside a singular pose.
const UNUSUAL: f64 = 0.1;

/// What a factorisation goes by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Marks {
    /// A row with a smaller pivot has lost its direction.
    pub(crate) small: f64,
    /// Rows with a smaller pivot are closed to round-off: what is left of φ turns velocities by φ/σ².
    pub(crate) beside: f64,
}

impl Marks {
    /// For steps of second order, whose own error is larger than what they lose here. (The proximal ε acts on singular
    /// values of about 1e-7.)
    pub(crate) const SECOND_ORDER: Self = Marks {
        small: 1e-6,
        beside: 0.0,
    };

    /// For steps of higher order, where the rows are this independent in a usual pose: bodies with little inertia about an
    /// axis make some weak everywhere.
    ///
    /// Steps that are `placed` land close to a pose only where short stages leave no other choice, and then as exactly as
    /// multipliers allow. Others may land so close that an iteration could choose another branch of the motion: a row that
    /// is left out cannot.
    pub(crate) fn high_order(usual: f64, placed: bool) -> Self {
        Marks {
            small: if placed { 1e-9 } else { 1e-6 },
            beside: super::WEAK_PIVOT.min(UNUSUAL * usual),
        }
    }
}
