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
    /// A length that no step can have; what it should be.
    Length(&'static str),
    /// A quantity became infinite or NaN.
    NonFinite(&'static str),
    /// M is not positive definite.
    Mass,
    /// The step was halved down to the smallest one; the row is the one that did not converge.
    Underflow { row: Option<usize>, step: f64 },
}

impl Fault {
    /// Refuses a step of h that no step can have, or back in time where the method has none.
    pub(crate) fn check_length(h: f64, goes_back: bool) -> Result<(), Fault> {
        match (h.is_finite() && h != 0.0, goes_back || h > 0.0) {
            (true, true) => Ok(()),
            (true, false) => Err(Fault::Length(
                "a positive length: this method does not go back in time",
            )),
            (false, _) => Err(Fault::Length("a finite length other than zero")),
        }
    }
}
