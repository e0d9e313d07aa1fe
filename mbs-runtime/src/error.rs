//! Errors of the runtime: what happened, where (joint, row, parameter, time), and what to do.

use crate::Model;
use std::fmt;

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

impl std::error::Error for UnknownName {}

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

/// Parameters that do not make a mechanism.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ParameterError {
    /// A parameter is NaN or infinite.
    NotFinite {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A mass or inertia is negative.
    Negative {
        /// The entry.
        entry: &'static str,
        /// Its argument.
        argument: &'static str,
        /// Its value.
        value: f64,
    },
    /// A length is zero or negative.
    NotPositive {
        /// The entry.
        entry: &'static str,
        /// Its argument.
        argument: &'static str,
        /// Its value.
        value: f64,
        /// Why it has to be positive.
        because: &'static str,
    },
    /// M is not positive definite: a motion has no mass.
    MassNotPositive {
        /// The coordinate at which the factorisation met a pivot that is not positive.
        coordinate: &'static str,
    },
    /// An inertia tensor is not positive definite.
    InertiaNotPositive {
        /// The body.
        body: &'static str,
        /// Its principal moments, kg m².
        moments: [f64; 3],
    },
    /// A principal moment exceeds the sum of the other two.
    InertiaTriangle {
        /// The body.
        body: &'static str,
        /// Its principal moments, kg m².
        moments: [f64; 3],
    },
}

impl fmt::Display for ParameterError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ParameterError::NotFinite { name, value } => {
                write!(out, "parameter `{name}` is {value}; give it a finite value")
            }
            ParameterError::Negative {
                entry,
                argument,
                value,
            } => write!(
                out,
                "`{argument}` of `{entry}` is negative ({value}); give it a positive value"
            ),
            ParameterError::NotPositive {
                entry,
                argument,
                value,
                because,
            } => write!(out, "`{argument}` of `{entry}` is {value}: {because}"),
            ParameterError::MassNotPositive { coordinate } => write!(
                out,
                "the mass matrix is not positive definite at coordinate `{coordinate}`: give the parts that move with it a positive mass and inertia"
            ),
            ParameterError::InertiaNotPositive { body, moments } => write!(
                out,
                "the inertia of `{body}` is not positive definite: its principal moments are {} kg m²; all three have to be positive",
                list(moments)
            ),
            ParameterError::InertiaTriangle { body, moments } => write!(
                out,
                "no body has the inertia of `{body}`: its principal moments are {} kg m², and none of them may exceed the sum of the other two",
                list(moments)
            ),
        }
    }
}

fn list([a, b, c]: &[f64; 3]) -> String {
    format!("{a:.6}, {b:.6} and {c:.6}")
}

impl std::error::Error for ParameterError {}
