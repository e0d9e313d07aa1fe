//! A name that the mechanism does not have, with those that it has.

use crate::Model;
use core::fmt;

/// A name that the mechanism does not have.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
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

impl Model {
    /// The place of a component of a joint's reaction in [`Model::reactions`].
    pub(crate) fn reaction_index(
        &self,
        joint: &str,
        component: &str,
    ) -> Result<usize, UnknownName> {
        let mut list = self.reactions.iter();
        let index = list.position(|r| r.joint == joint && r.component == component);
        index.ok_or_else(|| {
            let of_joint = self.reactions.iter().filter(|r| r.joint == joint);
            let components: Vec<&str> = of_joint.map(|r| r.component).collect();
            match components.is_empty() {
                true => UnknownName::new("joint with reactions", joint, self.joints()),
                false => UnknownName::new("component of this reaction", component, components),
            }
        })
    }

    /// The joints that have reactions, each once.
    fn joints(&self) -> Vec<&'static str> {
        let mut names: Vec<&str> = self.reactions.iter().map(|r| r.joint).collect();
        names.dedup();
        names
    }
}
