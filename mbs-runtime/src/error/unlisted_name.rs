//! A name that the mechanism does not have, without the feature `std`: it is not copied, as that would allocate.

use core::fmt;

/// A name that the mechanism does not have.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct UnknownName {
    /// The sort of name: `parameter`, `input`, `output`, `event`.
    pub what: &'static str,
}

impl UnknownName {
    /// The error for a name of this sort.
    pub fn new(what: &'static str, _: &str, _: impl IntoIterator<Item = &'static str>) -> Self {
        UnknownName { what }
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "no {} has the given name", self.what)
    }
}

impl core::error::Error for UnknownName {}
