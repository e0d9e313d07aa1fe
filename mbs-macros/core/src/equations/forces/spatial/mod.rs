//! Forces of space.

mod bushing;
mod torque;
mod torsion_spring;
mod wrench;

use super::{Action, Characteristic, Force, Load, force_in};
use crate::model::Arguments;

/// Reads a force element of space.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    match kind {
        "TorsionSpring" => torsion_spring::read(arguments),
        "Bushing" => bushing::read(arguments),
        "Torque" => torque::read(arguments),
        "Wrench" => wrench::read(arguments),
        _ => None,
    }
}
