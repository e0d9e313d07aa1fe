//! A wheel rolls on a line that is fixed in another part.

use super::super::rolling;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, Level, ReactionComponent};
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Rolling",
        group: Group::Joint,
        fields: &[
            positional(
                "wheel",
                Expects::Point,
                Absent::Required,
                "the centre of the wheel; reactions are the forces on it at the contact",
            ),
            positional(
                "track",
                Expects::Point,
                Absent::Required,
                "a point of the line on which it rolls",
            ),
            field(
                "radius",
                Expects::Known(Dimension::LENGTH),
                Absent::Required,
                "radius of the wheel",
            ),
            field(
                "axis",
                Expects::Axis,
                Absent::Assumed("X"),
                "direction of the line, in the axes of its part; the wheel is on its left",
            ),
        ],
        doc: "A wheel rolls without slip on a line that is fixed in another part, and stays on it: a row on positions and one on velocities.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let [wheel, track] = rolling::partners(arguments, ["wheel", "track"])?;
    let radius = arguments.scalar("radius")?;
    arguments.refuse_not_positive("radius", radius, "a wheel has a positive radius")?;
    let axis = arguments.axis("axis", track.owner)?;
    // n · (wheel − track) − r = 0, and the slip at wheel − r n along the line.
    let graph = arguments.graph();
    let normal = graph.perpendicular(axis);
    let gap = graph.vector_sub(wheel.position, track.position);
    let height = graph.dot(normal, gap);
    let touch = graph.sub(height, radius);
    let down = graph.vector_scale(radius, normal);
    let contact = graph.vector_sub(wheel.position, down);
    let slip = rolling::slip(arguments, &wheel, &track, contact);
    let graph = arguments.graph();
    let along = graph.dot(slip, axis);
    let reactions = ["fx", "fy"].into_iter().enumerate();
    Some(Joint {
        conditions: vec![
            Condition::position("touch", touch, Dimension::LENGTH),
            Condition {
                suffix: "slip".to_owned(),
                level: Level::Velocity,
                expr: along,
                dimension: Some(Dimension::VELOCITY),
            },
        ],
        reactions: reactions
            .map(|(k, name)| ReactionComponent {
                name,
                dimension: Dimension::FORCE,
                terms: vec![(0, normal[k]), (1, axis[k])],
            })
            .collect(),
        points: vec![track, wheel],
        ..Joint::default()
    })
}
