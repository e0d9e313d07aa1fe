//! The angles of two joints have a constant ratio.

use super::relation::{Relation, turning};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Gear",
        group: Group::Joint,
        fields: &[
            positional(
                "first",
                Expects::Joint,
                Absent::Required,
                "the driving joint, which turns",
            ),
            positional(
                "second",
                Expects::Joint,
                Absent::Required,
                "the driven joint; the reaction is the torque in it",
            ),
            field(
                "ratio",
                Expects::Known(Dimension::NONE),
                Absent::Required,
                "angle of the second per angle of the first",
            ),
            field(
                "offset",
                Expects::Known(Dimension::NONE),
                Absent::Assumed("0"),
                "angle of the second where that of the first is zero",
            ),
        ],
        doc: "The angles of two joints keep a ratio: 1 row.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
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
