//! Forces of the plane.

mod torque;
mod torsion_spring;

use super::{Action, Characteristic, Force, Load};
use crate::model::Arguments;

/// Reads a force element of the plane.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    match kind {
        "TorsionSpring" => torsion_spring::read(arguments),
        "Torque" => torque::read(arguments),
        _ => None,
    }
}
