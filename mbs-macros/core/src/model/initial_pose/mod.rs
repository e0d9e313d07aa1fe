//! Initial guesses of all local coordinates, in parameters.

mod at_home;
mod guesses;
mod held_angles;
mod joint;
mod planar;
mod quaternion;
mod spatial;

use super::elements::JointEntry;
use super::resolver::Resolver;
use super::tree::Tree;
use crate::schema::World;
use crate::symbolic::Expr;

pub(super) use guesses::Guesses;

/// The guesses of all coordinates that parts and the joints of the tree have.
pub(super) fn guesses(resolver: &mut Resolver, joints: &[JointEntry], tree: &Tree) -> Guesses {
    match resolver.world {
        World::Planar => {
            let mut guesses = planar::guesses(resolver, joints);
            planar::strokes(resolver, tree, &mut guesses);
            guesses
        }
        World::Spatial => spatial::guesses(resolver, joints, tree),
    }
}

/// The guessed velocities of the local coordinates that the tree carries in space, but those of parts whose screws turn as they slide.
/// (In the plane the guesses fulfil the joints.)
pub(super) fn carried_velocities(
    resolver: &mut Resolver,
    tree: &Tree,
    guesses: &Guesses,
) -> Vec<(u32, Expr)> {
    if resolver.world == World::Planar {
        return Vec::new();
    }
    let slides = |part| {
        let carrier = tree.carrier(part);
        carrier.is_some_and(|joint| joint::turns_as_it_slides(resolver, joint))
    };
    let parts = resolver.parts.iter().enumerate();
    let parts = parts.filter(|(index, _)| !slides(*index));
    let locals = parts.flat_map(|(index, part)| tree.dropped(index, part));
    let locals: Vec<u32> = locals.collect();
    let velocity = |local| (local, guesses.velocity(local, &mut resolver.graph));
    locals.into_iter().map(velocity).collect()
}
