//! Joints of space.
//!
//! Each is a selection of the same few conditions between two frames that coincide in the home pose: see
//! [`builder::Builder`].

mod builder;
mod constant_velocity;
mod cylindrical;
mod fixed;
mod gear;
mod planar;
mod point_on_line;
mod point_on_plane;
mod prismatic;
mod rack_pinion;
mod relation;
mod revolute;
mod screw;
mod sliding_point;
mod spherical;
mod universal;

use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

/// Reads a joint of space.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Joint> {
    match kind {
        "Revolute" => revolute::read(arguments),
        "Prismatic" => prismatic::read(arguments),
        "Cylindrical" => cylindrical::read(arguments),
        "Spherical" => spherical::read(arguments),
        "Universal" => universal::read(arguments),
        "ConstantVelocity" => constant_velocity::read(arguments),
        "Planar" => planar::read(arguments),
        "Fixed" => fixed::read(arguments),
        "Screw" => screw::read(arguments),
        "Gear" => gear::read(arguments),
        "RackPinion" => rack_pinion::read(arguments),
        "PointOnLine" => point_on_line::read(arguments),
        "PointOnPlane" => point_on_plane::read(arguments),
        _ => None,
    }
}
