//! Counted joint angles after the reduction: the angle of a joint of the tree is its coordinate, which is not limited
//! to one turn; only the other angles need a stored value.

use super::resolver::Resolver;
use super::tree::Tree;
use crate::symbolic::{Substitution, Symbol};

/// Replaces the counted angles of the joints of a tree, whose coordinates have their values in `substitution` or stand for
/// themselves. Answers the other angles, by their index in [`Resolver::unwrapped_angles`].
pub(super) fn replace(
    resolver: &mut Resolver,
    tree: &Tree,
    substitution: &mut Substitution,
) -> Vec<usize> {
    let graph = &mut resolver.graph;
    let mut others = Vec::new();
    for (index, unwrapped) in resolver.unwrapped_angles.iter().enumerate() {
        let mut joints = tree.joints.iter();
        let own = joints.find_map(|joint| {
            if joint.joint != unwrapped.joint {
                return None;
            }
            let local = *joint.angles().first()?;
            let sign = if joint.mobilizer.forwards { 1.0 } else { -1.0 };
            Some((Symbol::LocalPosition(local), sign))
        });
        let Some((local, sign)) = own else {
            others.push(index);
            continue;
        };
        let angle = match substitution.get(local) {
            Some(value) => value,
            None => graph.symbol(local),
        };
        let angle = graph.scale(sign, angle);
        // What was counted last is the same, so that no turns are added.
        substitution.insert(Symbol::UnwrappedAngle(index as u32), angle);
        substitution.equate(unwrapped.within, angle);
    }
    others
}

/// Gives the angles that need a memory their places among those that have one.
pub(super) fn renumber(resolver: &mut Resolver, kept: &[usize], substitution: &mut Substitution) {
    for (place, &index) in kept.iter().enumerate() {
        let memory = Symbol::UnwrappedAngle(place as u32);
        let name = format!("{}.angle", resolver.unwrapped_angles[index].joint);
        resolver.graph.set_name(memory, name);
        let value = resolver.graph.symbol(memory);
        substitution.insert(Symbol::UnwrappedAngle(index as u32), value);
    }
}
