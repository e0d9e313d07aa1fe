//! Forces of the plane.

mod torque;
mod torsion_spring;

use crate::model::arguments::Arguments;
use crate::model::elements::force::Force;

/// Reads a force element of the plane.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Force> {
    match kind {
        "TorsionSpring" => torsion_spring::read(arguments),
        "Torque" => torque::read(arguments),
        _ => None,
    }
}
