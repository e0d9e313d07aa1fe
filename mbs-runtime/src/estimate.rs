//! What a step tells of its own error.

/// By an embedded method.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Estimate {
    /// In sizes of the mechanism and radians.
    pub(crate) error: f64,
    /// Whether a force jumps or bends in the step, or the step is too long for any estimate: its terms of higher order are not
    /// smaller than those of lower order.
    pub(crate) is_rough: bool,
}

impl Estimate {
    /// By a method that does not see whether forces are smooth.
    pub(crate) fn of(error: f64) -> Self {
        Estimate {
            error,
            is_rough: false,
        }
    }

    /// Of two steps.
    pub(crate) fn with(self, other: Estimate) -> Self {
        Estimate {
            error: self.error + other.error,
            is_rough: self.is_rough || other.is_rough,
        }
    }
}
