//! Checks of arguments that follow from parameters.

use super::spin::possible;
use crate::ParameterError;

/// Refuses a mass or inertia that is negative.
///
/// # Errors
/// [`ParameterError::Negative`].
pub fn require_not_negative(
    entry: &'static str,
    argument: &'static str,
    value: f64,
) -> Result<(), ParameterError> {
    match value >= 0.0 {
        true => Ok(()),
        false => Err(ParameterError::Negative {
            entry,
            argument,
            value,
        }),
    }
}

/// Refuses a length that is not positive; `because` says why it has to be.
///
/// # Errors
/// [`ParameterError::NotPositive`].
pub fn require_positive(
    entry: &'static str,
    argument: &'static str,
    value: f64,
    because: &'static str,
) -> Result<(), ParameterError> {
    match value > 0.0 && value.is_finite() {
        true => Ok(()),
        false => Err(ParameterError::NotPositive {
            entry,
            argument,
            value,
            because,
        }),
    }
}

/// Refuses an inertia, xx, xy, xz, yy, yz and zz, that no body has.
///
/// # Errors
/// [`ParameterError::InertiaNotPositive`] and [`ParameterError::InertiaTriangle`].
pub fn require_inertia(body: &'static str, inertia: [f64; 6]) -> Result<(), ParameterError> {
    let [xx, xy, xz, yy, yz, zz] = inertia;
    possible(&[[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], body).map(|_| ())
}
