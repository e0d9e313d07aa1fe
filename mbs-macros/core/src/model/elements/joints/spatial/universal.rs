//! Two points coincide, and two crossed pins, one held by each partner, stay at right angles.

use super::builder::Builder;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::geometry::Vector;
use crate::model::joint_frames::JointFrames;
use crate::model::mobilizer::{Freedom, Mobilizer};
use crate::schema::spatial::{AT, CHILD, PARENT};
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Universal",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            AT,
            field(
                "axis",
                Expects::Axis,
                Absent::Required,
                "the pin held by the parent, in the home pose",
            ),
            field(
                "second_axis",
                Expects::Axis,
                Absent::Required,
                "the pin held by the child, in the home pose; across the first",
            ),
        ],
        doc: "Two points coincide and two crossed pins stay at right angles: 4 rows.",
        joint: Some(JointTraits {
            carries: true,
            elsewhere: "use `Revolute`, or write `world: Spatial(…)`",
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    let (first, second) = (
        arguments.direction("axis")?,
        arguments.direction("second_axis")?,
    );
    let cosine = arguments.graph().dot(first, second);
    let cosine = arguments.by_default(cosine);
    if cosine.abs() > 1e-6 {
        let angle = cosine.clamp(-1.0, 1.0).acos().to_degrees();
        return arguments.fail(
            "second_axis",
            format!(
                "the pins of a universal joint cross at right angles, but these at {angle:.3}°; turn one of them, such as `axis = X, second_axis = Y`"
            ),
        );
    }
    let pin = arguments.fixed_direction(second, frames.child.point.owner);
    let mobilizer = mobilizer(arguments, &frames, second);
    // d = 0 and z_p · pin = 0; λ pin × z_p is the torque on the child.
    let mut builder = Builder::new(arguments.graph(), &frames).coincide();
    let axis = frames.parent.axes[2];
    let cosine = builder.graph.dot(axis, pin);
    let condition = builder.push("pins", cosine, Dimension::NONE);
    let torque = builder.graph.cross(pin, axis);
    builder.acts(condition, None, Some(torque));
    Some(Joint {
        mobilizer: Some(mobilizer),
        coincident: Some(frames.origins()),
        ..builder.finish()
    })
}

/// A turn about the parent's pin z, then one about the child's p: in the home pose the frames are (p, z × p, z), and after
/// the first turn (z × p, z, p).
fn mobilizer(arguments: &mut Arguments, frames: &JointFrames, pin: Vector) -> Mobilizer {
    let axis = arguments.home_direction(&frames.parent);
    let graph = arguments.graph();
    let across = graph.cross(axis, pin);
    let [x, y, z] = graph.ground_axes();
    let parent = arguments.reattached(&frames.parent, [pin, across, axis]);
    let child = arguments.reattached(&frames.child, [across, axis, pin]);
    let turns = [Freedom::Turn(None), Freedom::Turn(Some([y, z, x]))];
    Mobilizer::new(&parent, &child, turns)
}
