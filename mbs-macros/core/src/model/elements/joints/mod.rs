//! Joints and constraints as they are declared, one file each. Joints of one world are in `planar` and `spatial`,
//! conditions of both here.

mod bar_length;
mod conditions;
mod coupling;
mod distance;
mod drive;
mod holonomic;
mod nonholonomic;
mod planar;
mod relation;
mod spatial;

use super::joint::Joint;
use crate::model::arguments::Arguments;
use crate::schema::World;

pub(in crate::model) use bar_length::bar_length;

/// Reads a joint or constraint.
pub(in crate::model) fn read(kind: &str, arguments: &mut Arguments) -> Option<Joint> {
    match kind {
        "Distance" => distance::read(arguments),
        "Coupling" => coupling::read(arguments),
        "Drive" => drive::read(arguments),
        "Holonomic" => holonomic::read(arguments),
        "Nonholonomic" => nonholonomic::read(arguments),
        _ => match arguments.world() {
            World::Planar => planar::read(kind, arguments),
            World::Spatial => spatial::read(kind, arguments),
        },
    }
}
