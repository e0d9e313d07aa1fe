//! What a tolerance finds too large.

/// What a tolerance finds too large.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ErrorOf {
    /// The coordinate of this velocity, as the model names it, which is worst in a comparison of steps.
    Velocity(&'static str),
    /// The motion as a whole, by the estimate of an embedded method or where other steps do not converge.
    Motion,
    /// The energy balance.
    Balance,
    /// The branch of the motion past a pose that is nearly singular.
    Branch,
}
