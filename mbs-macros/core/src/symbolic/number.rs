//! Numbers that can be keys.

use std::fmt;

/// A number, compared and hashed by its bits: NaN is equal to itself, and −0 is stored as 0.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Number(u64);

impl Number {
    /// Zero, for patterns.
    pub const ZERO: Number = Number(0);

    /// A number.
    pub fn new(value: f64) -> Number {
        // −0 + 0 is 0.
        Number((value + 0.0).to_bits())
    }

    /// What numbers are compared by.
    pub(crate) fn bits(self) -> u64 {
        self.0
    }

    /// Its value.
    pub fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}

impl fmt::Debug for Number {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value().fmt(out)
    }
}
