//! Whether an output of a wrong declaration is a vector, by the look of its expression: its field then has the type that
//! the user's program expects. Only the tree of stage 1 is there.

use crate::names::base;
use crate::schema::World;
use crate::syntax::{Declaration, Entry, MAX_DEPTH, inner, reference};
use std::collections::BTreeSet;
use syn::{BinOp, Expr, Member};

/// Parts, whose `x`, `y` and `z` are axes.
const PARTS: [&str; 3] = ["Bar", "Body", "Particle"];

/// Members and methods that are vectors, whatever they belong to.
const VECTORS: [&str; 9] = [
    "a",
    "b",
    "origin",
    "center",
    "velocity",
    "angular_velocity",
    "point",
    "velocity_at",
    "unit",
];

/// The number of components of an entry's first argument, if it seems to be a vector.
pub(super) fn components(declaration: &Declaration, entry: &Entry) -> Option<usize> {
    let value = entry.positional.first()?;
    let world = declaration.world_kind();
    let size = match world {
        World::Planar => 2,
        World::Spatial => 3,
    };
    let mut tree = Tree {
        declaration,
        world,
        seen: BTreeSet::new(),
    };
    tree.is_vector(value, MAX_DEPTH).then_some(size)
}

struct Tree<'d> {
    declaration: &'d Declaration,
    world: World,
    /// The entries that were looked at: what one of them says is the answer, unless it is no vector.
    seen: BTreeSet<usize>,
}

impl<'d> Tree<'d> {
    /// `depth` bounds the way through names and nested expressions.
    fn is_vector(&mut self, expr: &Expr, depth: usize) -> bool {
        let Some(depth) = depth.checked_sub(1) else {
            return false;
        };
        match inner(expr) {
            Expr::Array(_) => true,
            Expr::Unary(unary) => self.is_vector(&unary.expr, depth),
            Expr::Binary(binary) => {
                self.is_vector(&binary.left, depth)
                    || !matches!(binary.op, BinOp::Div(_)) && self.is_vector(&binary.right, depth)
            }
            Expr::Field(field) => match &field.member {
                Member::Named(word) if ["x", "y", "z"].iter().any(|axis| word == axis) => {
                    self.is_part(&field.base)
                }
                Member::Named(word) => VECTORS.iter().any(|known| word == known),
                Member::Unnamed(_) => false,
            },
            Expr::MethodCall(call) => self.gives_vector(&call.method.to_string(), None, depth),
            Expr::Call(call) => match &*call.func {
                Expr::Path(path) => path.path.get_ident().is_some_and(|word| {
                    self.gives_vector(&word.to_string(), call.args.first(), depth)
                }),
                _ => false,
            },
            Expr::Path(_) | Expr::Index(_) => {
                let Some((index, entry)) = self.entry(expr) else {
                    return false;
                };
                let named = entry.kind == "Let" || entry.kind == "Output";
                let value = entry.positional.first();
                let value = value.filter(|_| named && self.seen.insert(index));
                entry.kind == "Point" || value.is_some_and(|value| self.is_vector(value, depth))
            }
            _ => false,
        }
    }

    /// Whether a function of this name gives a vector.
    fn gives_vector(&mut self, word: &str, argument: Option<&Expr>, depth: usize) -> bool {
        match word {
            "reject" => true,
            "cross" => self.world == World::Spatial,
            "rate" => argument.is_some_and(|argument| self.is_vector(argument, depth)),
            word => VECTORS.contains(&word),
        }
    }

    fn is_part(&self, expr: &Expr) -> bool {
        let is_ground = matches!(inner(expr), Expr::Path(path) if path.path.is_ident("ground"));
        let entry = self.entry(expr);
        is_ground || entry.is_some_and(|(_, entry)| PARTS.iter().any(|part| entry.kind == part))
    }

    /// The entry, or a member of the family, that an expression names, with its index.
    fn entry(&self, expr: &Expr) -> Option<(usize, &'d Entry)> {
        let word = reference(expr)?.ok()?.base;
        let mut entries = self.declaration.entries.iter().enumerate();
        entries.find(|(_, entry)| base(entry.name.as_str()) == word)
    }
}
