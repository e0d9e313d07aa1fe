//! From the declared guess to a state that satisfies the constraints.

mod closed;
mod continuation;
mod guess;
mod newton;

// The verdict on the rows, and values that are held: lists of names.
#[cfg(feature = "std")]
mod changes;
#[cfg(feature = "std")]
mod closing;
#[cfg(feature = "std")]
mod conditions;
#[cfg(feature = "std")]
mod differences;
#[cfg(feature = "std")]
mod held;
#[cfg(feature = "std")]
mod independence;
#[cfg(feature = "std")]
mod jump;
#[cfg(feature = "std")]
mod large;
#[cfg(feature = "std")]
mod stationary;
#[cfg(feature = "std")]
mod verdict;

pub(crate) use closed::{check, closed};
#[cfg(feature = "std")]
pub(crate) use {
    conditions::Wanted,
    guess::check_rates,
    independence::{independent_rows, vanishes},
    jump::{jump, refit},
    verdict::{assemble, inspect},
};
