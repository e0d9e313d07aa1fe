//! Which coordinates a mechanism is described by.

use crate::diagnostics::{Errors, Place, did_you_mean};
use crate::syntax::Declaration;
use syn::Expr as Syntax;

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

/// What the world asks for by `coordinates =`; `None` is `Auto`.
pub fn requested(declaration: &Declaration, errors: &mut Errors) -> Option<Formulation> {
    let world = declaration.world.as_ref()?;
    let syntax = &world.named("coordinates")?.value;
    let name = match syntax {
        Syntax::Path(path) => path.path.get_ident().map(ToString::to_string),
        _ => None,
    };
    let name = name.unwrap_or_default();
    if name == "Auto" {
        return None;
    }
    let found = ALL.into_iter().find(|known| known.name() == name);
    if found.is_none() {
        let names = ALL.map(Formulation::name);
        let hint = did_you_mean(&name, names.into_iter().chain(["Auto"]));
        errors.at(
            Place::of(syntax),
            format!("expected `Auto`, `Natural`, `Reference` or `Joint`{hint}"),
        );
    }
    found
}
