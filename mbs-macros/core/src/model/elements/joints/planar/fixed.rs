//! Two points coincide and their frames keep their angle.

use super::alignment;
use super::held::{coincidence, torque};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::common::{CHILD, PARENT};
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Fixed",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            field(
                "angle",
                Expects::Known(Dimension::NONE),
                Absent::Assumed("0"),
                "angle of the child's frame against the parent's",
            ),
        ],
        doc: "The two points coincide and the frames keep their angle.",
        joint: Some(JointTraits {
            carries: true,
            arguments_elsewhere: &["at", "axis"],
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let alignment = alignment::read(arguments, &parent, &child)?;
    let held_angle = alignment.held_angle([&parent, &child]);
    let graph = arguments.graph();
    let mobilizer = alignment.mobilizer(graph, [&parent, &child], None);
    let mut joint = coincidence(graph, &parent, &child);
    joint.conditions.push(alignment.condition(graph));
    joint.reactions.push(torque(graph, 2));
    Some(Joint {
        mobilizer: Some(mobilizer),
        held_angle: Some(held_angle),
        coincident: Some([parent, child]),
        ..joint
    })
}
