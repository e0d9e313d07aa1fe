//! Joints and constraints as they are declared, one file each. Joints of one world are in `planar` and `spatial`,
//! those of both worlds here.

mod bar_length;
mod conditions;
mod coupling;
mod distance;
mod drive;
mod holonomic;
mod nonholonomic;
mod planar;
mod relation;
mod rolling;
mod spatial;

use super::joint::Joint;
use super::kind::JointKind;
use crate::model::arguments::Arguments;
use crate::schema::World;

pub(in crate::model) use bar_length::bar_length;

/// The kinds that both worlds share.
pub(in crate::model) const KINDS: &[JointKind] = &[
    distance::KIND,
    coupling::KIND,
    holonomic::KIND,
    nonholonomic::KIND,
    drive::KIND,
];

/// The kinds of one world alone.
pub(in crate::model) fn own_kinds(world: World) -> &'static [JointKind] {
    match world {
        World::Planar => planar::KINDS,
        World::Spatial => spatial::KINDS,
    }
}

/// Reads a joint or constraint.
pub(in crate::model) fn read(kind: &str, arguments: &mut Arguments) -> Option<Joint> {
    let mut kinds = KINDS.iter().chain(own_kinds(arguments.world()));
    let found = kinds.find(|joint| joint.kind.name == kind)?;
    (found.read)(arguments)
}
