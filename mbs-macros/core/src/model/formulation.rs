//! Which coordinates a mechanism is described by.

use crate::diagnostics::{Errors, Place, did_you_mean};
use crate::syntax::{Declaration, Entry};
use syn::Expr as Syntax;

/// The name of the argument.
pub(super) const COORDINATES: &str = "coordinates";

/// A choice of coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formulation {
    /// Points where they will do: slender bars are their end points, joined points are one.
    Natural,
    /// Centre of mass and orientation of every part; every joint is rows.
    Reference,
    /// The motions that joints allow along a tree from the ground; joints beside the tree are rows.
    Joint,
}

impl Formulation {
    /// As written.
    pub fn name(self) -> &'static str {
        match self {
            Formulation::Natural => "Natural",
            Formulation::Reference => "Reference",
            Formulation::Joint => "Joint",
        }
    }
}

/// All, in the order in which they are tried.
pub const ALL: [Formulation; 3] = [
    Formulation::Natural,
    Formulation::Reference,
    Formulation::Joint,
];

/// Those of a part with an orientation of its own.
pub const OF_BODIES: [Formulation; 2] = [Formulation::Reference, Formulation::Joint];

/// One description of a mechanism.
#[derive(Debug, Clone)]
pub struct Description {
    /// The coordinates of parts without their own `coordinates =`.
    pub formulation: Formulation,
    /// Joints of which no row is solved.
    pub keep: Vec<String>,
    /// Joints that close loops, instead of those that would be cut.
    pub cut: Option<Vec<String>>,
}

impl From<Formulation> for Description {
    fn from(formulation: Formulation) -> Self {
        Description {
            formulation,
            keep: Vec::new(),
            cut: None,
        }
    }
}

/// The `coordinates =` of the world; `None` is `Auto`.
pub fn requested(declaration: &Declaration, errors: &mut Errors) -> Option<Formulation> {
    asked(declaration.world.as_ref()?, &ALL, errors)
}

/// The `coordinates =` of an entry, one of those possible; `None` is `Auto`.
pub(super) fn asked(
    entry: &Entry,
    possible: &[Formulation],
    errors: &mut Errors,
) -> Option<Formulation> {
    let syntax = &entry.named(COORDINATES)?.value;
    let name = match syntax {
        Syntax::Path(path) => path.path.get_ident().map(ToString::to_string),
        _ => None,
    };
    let name = name.unwrap_or_default();
    if name == "Auto" {
        return None;
    }
    let found = possible.iter().find(|known| known.name() == name);
    if found.is_none() {
        let names = possible.iter().map(|known| known.name());
        let names: Vec<&str> = ["Auto"].into_iter().chain(names).collect();
        let hint = did_you_mean(&name, names.iter().copied());
        let list: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        let (last, others) = list
            .split_last()
            .map_or(("", &[][..]), |(last, others)| (last.as_str(), others));
        let excluded = match ALL.iter().any(|known| known.name() == name) {
            true => format!(
                "`{}`, a `{}`, has no `{name}` coordinates: ",
                entry.name, entry.kind
            ),
            false => String::new(),
        };
        let message = match others {
            [] => format!("{excluded}leave `coordinates =` out"),
            _ => format!("{excluded}expected {} or {last}{hint}", others.join(", ")),
        };
        errors.at(Place::of(syntax), message);
    }
    found.copied()
}
