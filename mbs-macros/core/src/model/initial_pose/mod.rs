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
