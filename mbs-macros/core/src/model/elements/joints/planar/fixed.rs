//! Two points coincide and their frames keep their angle.

use super::alignment;
use super::held::{coincidence, torque};
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let alignment = alignment::read(arguments, &parent, &child)?;
    let graph = arguments.graph();
    let mobilizer = alignment.mobilizer(graph, [&parent, &child], None);
    let mut joint = coincidence(graph, &parent, &child);
    joint.conditions.push(alignment.condition(graph));
    joint.reactions.push(torque(graph, 2));
    Some(Joint {
        mobilizer: Some(mobilizer),
        coincident: Some([parent, child]),
        ..joint
    })
}
