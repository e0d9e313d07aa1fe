//! Two points coincide, and the partners turn about their axes at the same rate for every angle between these.

use super::builder::Builder;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::spatial::{AT, AXIS, CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "ConstantVelocity",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT, AXIS],
        doc: "Two points coincide and the shafts, along the axis where they are aligned, turn at the same rate whatever their angle: 4 rows. With `axis` they are aligned in the home pose. Shafts at an angle there, each along the x axis of its part, are given by frames: `ConstantVelocity(inner.frame([0.0, 0.0, 0.0], X), outer.frame([0.0, 0.0, 0.0], X))`.",
        joint: Some(JointTraits {
            elsewhere: "use `Revolute`, or write `world: Spatial(…)`",
            ..JointTraits::NONE
        }),
    },
    read,
};

/// d = 0 and ½ (p_x · c_y − p_y · c_x) = 0: the one rotation that leads from p to c is about an axis across both
/// shafts, so that the plane of contact halves the angle between them.
fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    let mut builder = Builder::new(arguments.graph(), &frames).coincide();
    let (p, c) = (frames.parent.axes, frames.child.axes);
    let graph = &mut *builder.graph;
    let (first, second) = (graph.dot(p[0], c[1]), graph.dot(p[1], c[0]));
    let twist = graph.linear(0.0, &[(first, 0.5), (second, -0.5)]);
    let torques = [graph.cross(c[1], p[0]), graph.cross(c[0], p[1])];
    let torque =
        std::array::from_fn(|k| graph.linear(0.0, &[(torques[0][k], 0.5), (torques[1][k], -0.5)]));
    let condition = builder.push("twist", twist, Dimension::NONE);
    builder.acts(condition, None, Some(torque));
    Some(Joint {
        coincident: Some(frames.origins()),
        ..builder.finish()
    })
}
