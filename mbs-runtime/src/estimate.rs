//! The estimate of the error of a step by an embedded method.

/// Of a step, or of a pair of steps.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Estimate {
    /// In sizes of the mechanism and radians.
    pub(crate) error: f64,
    /// The error of the work of forces without potential, J, in driven mechanisms: there it does not show in the motion.
    pub(crate) work: f64,
    /// Whether the terms of higher order are not small beside those of lower order: a force jumps or bends in the step, or the
    /// step is too long.
    pub(crate) is_rough: bool,
    /// Of states, relative to their sizes, by the embedded formula, and raised to the order of the step; zero by methods that see
    /// the beginning of a step in their results.
    pub(crate) of_states: [f64; 2],
}

impl Estimate {
    /// By a method that does not see whether forces are smooth.
    pub(crate) fn smooth(error: f64, work: f64) -> Self {
        Estimate {
            error,
            work,
            is_rough: false,
            of_states: [0.0; 2],
        }
    }

    /// Of both steps.
    pub(crate) fn plus(self, other: Estimate) -> Self {
        Estimate {
            error: self.error + other.error,
            work: self.work + other.work,
            is_rough: self.is_rough || other.is_rough,
            of_states: [0, 1].map(|of| self.of_states[of] + other.of_states[of]),
        }
    }
}
