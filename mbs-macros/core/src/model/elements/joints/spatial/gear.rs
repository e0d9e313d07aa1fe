//! The angles of two joints keep a ratio.

use super::relation::{Relation, turning};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (first, second) = (turning(arguments, "first"), turning(arguments, "second"));
    let (first, second) = (first?, second?);
    if first.name == second.name {
        return arguments.fail(
            "second",
            "a gear couples two different joints; name another joint",
        );
    }
    let (ratio, offset) = (
        arguments.scalar("ratio"),
        arguments.scalar_or("offset", 0.0),
    );
    let relation = Relation {
        variables: [&first, &second].map(|joint| arguments.joint_angle(joint)),
        joints: [first, second],
        ratio: ratio?,
        offset: offset?,
        unit: Dimension::NONE,
        reaction: ("torque", Dimension::TORQUE),
    };
    Some(relation.joint(arguments))
}
