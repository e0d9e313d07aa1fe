//! Forces of space.

mod bushing;
mod torque;
mod torsion_spring;
mod wrench;

use crate::model::arguments::Arguments;
use crate::model::elements::force::Force;

/// Reads a force element of space.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Force> {
    match kind {
        "TorsionSpring" => torsion_spring::read(arguments),
        "Bushing" => bushing::read(arguments),
        "Torque" => torque::read(arguments),
        "Wrench" => wrench::read(arguments),
        _ => None,
    }
}
