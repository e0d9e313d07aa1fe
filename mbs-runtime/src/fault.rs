//! The reason for which a step failed; small, because every step returns it. The stepper adds
//! names, time and step.

/// The reason for which a step failed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Fault {
    /// A row did not converge.
    Row {
        row: usize,
        residual: f64,
        iterations: usize,
    },
    /// A stage has moved the mechanism by so many of its lengths, or radians, beside what its velocities account for.
    Astray(f64),
    /// The equations of an implicit flow did not converge.
    Flow { residual: f64, iterations: usize },
    /// A quantity became infinite or NaN.
    NonFinite(&'static str),
    /// M is not positive definite.
    Mass,
    /// The step was halved down to the smallest one; the row is the one that did not converge.
    Underflow { row: Option<usize>, step: f64 },
}
