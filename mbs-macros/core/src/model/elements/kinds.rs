//! All kinds of entries: values, parts and forces from the schema, joints and conditions from their files.

use super::joints;
use super::kind::JointKind;
use crate::schema::{Kind, Kinds, World, common, contact, planar, spatial};
use std::sync::LazyLock;

static ALL: LazyLock<Kinds> = LazyLock::new(|| {
    let with = |kinds: &[Kind], joints: &[JointKind]| -> Vec<Kind> {
        let joints = joints.iter().map(|joint| joint.kind);
        kinds.iter().copied().chain(joints).collect()
    };
    Kinds::new([
        with(&[common::KINDS, contact::KINDS].concat(), joints::KINDS),
        with(planar::KINDS, joints::own_kinds(World::Planar)),
        with(spatial::KINDS, joints::own_kinds(World::Spatial)),
    ])
});

/// The kinds of both worlds.
pub fn kinds() -> &'static Kinds {
    &ALL
}
