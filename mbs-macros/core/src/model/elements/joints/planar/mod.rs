//! Joints of the plane.

mod alignment;
mod fixed;
mod gear;
mod held;
mod point_on_line;
mod prismatic;
mod revolute;
mod rolling;

use crate::model::elements::kind::JointKind;

/// The kinds of the plane.
pub(super) const KINDS: &[JointKind] = &[
    revolute::KIND,
    prismatic::KIND,
    fixed::KIND,
    point_on_line::KIND,
    rolling::KIND,
    gear::KIND,
];
