//! The child slides along an axis of the parent and does not turn against it.

use super::alignment;
use super::held::{across, torque};
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let alignment = alignment::read(arguments, &parent, &child)?;
    let own = arguments.own_axis("axis")?;
    let axis = arguments.axis("axis", parent.owner)?;
    let graph = arguments.graph();
    let mobilizer = alignment.mobilizer(graph, [&parent, &child], Some(own));
    // n · (child − parent) = 0 with n across the axis, and the angle.
    let mut joint = across(graph, &parent, &child, axis, "across");
    joint.conditions.push(alignment.condition(graph));
    joint.reactions.push(torque(graph, 1));
    Some(Joint {
        mobilizer: Some(mobilizer),
        ..joint
    })
}
