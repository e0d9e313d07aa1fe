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
mod rolling;
mod screw;
mod sliding_point;
mod spherical;
mod universal;

use crate::model::elements::kind::JointKind;

/// The kinds of space.
pub(super) const KINDS: &[JointKind] = &[
    revolute::KIND,
    prismatic::KIND,
    cylindrical::KIND,
    spherical::KIND,
    universal::KIND,
    constant_velocity::KIND,
    planar::KIND,
    fixed::KIND,
    screw::KIND,
    gear::KIND,
    rack_pinion::KIND,
    point_on_line::KIND,
    point_on_plane::KIND,
    rolling::KIND,
];
