//! A name that the mechanism does not have, with those that it has.

use core::fmt;

/// A name that the mechanism does not have.
#[derive(Debug, Clone, PartialEq)]
pub struct UnknownName {
    /// The sort of name: `parameter`, `input`, `output`, `event`.
    pub what: &'static str,
    /// The name that was given.
    pub name: String,
    /// The names there are.
    pub known: Vec<&'static str>,
}

impl UnknownName {
    /// The error for `name`, given the names there are.
    pub fn new(
        what: &'static str,
        name: &str,
        known: impl IntoIterator<Item = &'static str>,
    ) -> Self {
        UnknownName {
            what,
            name: name.to_owned(),
            known: known.into_iter().collect(),
        }
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "no {} is named `{}`; ", self.what, self.name)?;
        match self.known.as_slice() {
            [] => write!(out, "this mechanism has none"),
            known => write!(out, "there are: {}", known.join(", ")),
        }
    }
}

impl core::error::Error for UnknownName {}
