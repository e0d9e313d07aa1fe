//! The outcome of the reduction: local coordinates in terms of the generalized ones.

use super::parts::Part;
use super::solved::Solved;
use super::tree::BodyTwist;
use crate::symbolic::{Graph, Substitution, Symbol};
use std::collections::HashSet;

/// A joint that left no row: its points were merged.
#[derive(Debug, Clone)]
pub struct MergedJoint {
    /// The joint's name.
    pub joint: String,
    /// The force on the child is the force that these points need: the first local coordinates of the ends of parts on
    /// the child's side. Empty where the child is the ground; then `parent` is taken with the opposite sign.
    pub child: Vec<u32>,
    /// The same for the parent's side.
    pub parent: Vec<u32>,
}

/// The outcome of the reduction.
pub(super) struct Reduction {
    pub substitution: Substitution,
    pub merged: Vec<MergedJoint>,
    pub sentences: Vec<String>,
    /// Velocities of the parts that the tree carries.
    pub twists: Vec<BodyTwist>,
    /// Rows that were solved, and the coordinates that followed from them.
    pub solved: Solved,
    /// Counted joint angles that need a memory.
    pub unwrapped_angles: Vec<usize>,
    /// Joints that left no rows: those of the tree, and those whose points were merged.
    pub dissolved: HashSet<String>,
    /// Local coordinates that stay, in order: (local, name).
    pub kept: Vec<(u32, String)>,
}

impl Reduction {
    /// Whether a joint left no row.
    pub(super) fn dissolved(&self, joint: &str) -> bool {
        self.dissolved.contains(joint)
    }

    /// The generalized coordinate with which a local one moves; `None` if it is held, or moves with several.
    pub(super) fn coordinate_of(&self, graph: &Graph, local: u32) -> Option<u32> {
        let value = self.substitution.get(Symbol::LocalPosition(local));
        let symbols = graph.symbols(value).into_iter();
        let mut indices = symbols.filter_map(|symbol| match symbol {
            Symbol::Coordinate(index) => Some(index),
            _ => None,
        });
        indices.next().filter(|_| indices.next().is_none())
    }

    /// The local coordinates that stay, with their names.
    pub(super) fn kept(&self) -> &[(u32, String)] {
        &self.kept
    }

    /// Whether every local velocity has its value, in which there are no local ones.
    pub(super) fn is_complete(&self, graph: &Graph, parts: &[Part]) -> bool {
        let local = |symbol: Symbol| {
            symbol.is_local_position() || matches!(symbol, Symbol::LocalVelocity(_))
        };
        let mut locals = parts.iter().flat_map(|part| &part.locals);
        locals.all(|&own| {
            let value = self.substitution.get(Symbol::LocalVelocity(own));
            value.is_some_and(|value| !graph.depends_on(value, local))
        })
    }
}
