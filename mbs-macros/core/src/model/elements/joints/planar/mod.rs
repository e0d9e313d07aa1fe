//! Joints of the plane.

mod alignment;
mod fixed;
mod gear;
mod held;
mod point_on_line;
mod prismatic;
mod revolute;

use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

/// Reads a joint of the plane.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Joint> {
    match kind {
        "Revolute" => revolute::read(arguments),
        "Prismatic" => prismatic::read(arguments),
        "Fixed" => fixed::read(arguments),
        "PointOnLine" => point_on_line::read(arguments),
        "Gear" => gear::read(arguments),
        _ => None,
    }
}
