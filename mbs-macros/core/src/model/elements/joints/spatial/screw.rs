//! The child slides along the axis as it turns about it.

use super::builder::Builder;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::mobilizer::Freedom;
use crate::schema::spatial::{AT, AXIS, CHILD, PARENT};
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field};
use std::f64::consts::PI;

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Screw",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            AT,
            AXIS,
            field(
                "pitch",
                Expects::Known(Dimension::LENGTH),
                Absent::Required,
                "stroke per turn; negative for a left-hand thread",
            ),
        ],
        doc: "The child slides along the axis as it turns about it: 5 rows. It has `angle`, `rate`, `stroke` and `speed`.",
        joint: Some(JointTraits {
            turns: true,
            slides: true,
            carries: true,
            elsewhere: "use `Prismatic` or `Revolute`, or write `world: Spatial(…)`",
            ..JointTraits::NONE
        }),
    },
    read,
};

/// Cylindrical, and stroke = pitch · angle / 2π; λ is a force along the axis and −λ pitch / 2π a torque about it.
fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    let pitch = arguments.scalar("pitch")?;
    let (angle, stroke) = (arguments.joint_angle(&frames), arguments.stroke(&frames));
    let mut builder = Builder::new(arguments.graph(), &frames)
        .on_plane(0)
        .on_plane(1)
        .parallel();
    let axis = frames.parent.axes[2];
    let graph = &mut *builder.graph;
    let lead = graph.scale(0.5 / PI, pitch);
    let advance = graph.mul(lead, angle);
    let thread = graph.sub(stroke, advance);
    let minus = graph.neg(lead);
    let torque = graph.vector_scale(minus, axis);
    let condition = builder.push("thread", thread, Dimension::LENGTH);
    builder.acts(condition, Some(axis), Some(torque));
    Some(Joint {
        mobilizer: Some(frames.mobilizer([Freedom::Helix(lead)])),
        ..builder.finish()
    })
}
