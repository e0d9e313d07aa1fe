//! The child slides along an axis of the parent and does not rotate relative to it.

use super::alignment;
use super::held::{across, torque};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::common::{CHILD, PARENT};
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Prismatic",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            field(
                "axis",
                Expects::Axis,
                Absent::Assumed("X"),
                "direction of sliding, in the parent's axes",
            ),
            field(
                "angle",
                Expects::Known(Dimension::NONE),
                Absent::Assumed("0"),
                "angle of the child's frame against the parent's",
            ),
        ],
        doc: "The child slides along an axis of the parent and does not turn against it. It has `stroke` and `speed`: of the child's point from the parent's, along the axis.",
        joint: Some(JointTraits {
            carries: true,
            arguments_elsewhere: &["at"],
            slides: true,
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let alignment = alignment::read(arguments, &parent, &child)?;
    let own = arguments.own_axis("axis")?;
    let axis = arguments.axis("axis", parent.owner)?;
    let held_angle = alignment.held_angle([&parent, &child]);
    let graph = arguments.graph();
    let mobilizer = alignment.mobilizer(graph, [&parent, &child], Some(own));
    // n · (child − parent) = 0 with n across the axis, and the angle.
    let mut joint = across(graph, &parent, &child, axis, "across");
    joint.conditions.push(alignment.condition(graph));
    joint.reactions.push(torque(graph, 1));
    Some(Joint {
        mobilizer: Some(mobilizer),
        held_angle: Some(held_angle),
        ..joint
    })
}
