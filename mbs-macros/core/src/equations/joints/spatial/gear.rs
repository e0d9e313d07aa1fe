//! The angles of two joints keep a ratio.

use super::{Joint, Relation};
use crate::model::{Arguments, Dimension, JointFrames};

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
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
    Some(Box::new(Relation {
        owners: Relation::owners([&first, &second]),
        first: arguments.joint_angle(&first),
        second: arguments.joint_angle(&second),
        ratio: ratio?,
        offset: offset?,
        unit: Dimension::NONE,
        reaction: ("torque", Dimension::TORQUE),
    }))
}

/// A joint that turns.
pub(super) fn turning(arguments: &mut Arguments, field: &str) -> Option<JointFrames> {
    let joint = arguments.joint(field)?;
    if !joint.turns() {
        let (kind, name) = (&joint.kind, &joint.name);
        return arguments.fail(
            field,
            format!(
                "`{name}` is a `{kind}`, which has no angle; name a `Revolute` or `Cylindrical`"
            ),
        );
    }
    Some(joint)
}
