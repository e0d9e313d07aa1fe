//! A thin disk rolls on a plane that is fixed in another part.

use super::super::rolling;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, Level, ReactionComponent};
use crate::model::elements::kind::JointKind;
use crate::model::geometry::{Axes, Vector};
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};
use crate::symbolic::{Expr, Graph};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Rolling",
        group: Group::Joint,
        fields: &[
            positional(
                "wheel",
                Expects::Point,
                Absent::Required,
                "the centre of the disk; reactions are the forces on it at the contact",
            ),
            positional(
                "track",
                Expects::Point,
                Absent::Required,
                "a point of the plane on which it rolls",
            ),
            field(
                "radius",
                Expects::Known(Dimension::LENGTH),
                Absent::Required,
                "radius of the disk",
            ),
            field(
                "axis",
                Expects::Axis,
                Absent::Assumed("Y"),
                "axis of the disk in the home pose, in the ground's axes",
            ),
            field(
                "normal",
                Expects::Axis,
                Absent::Assumed("Z"),
                "normal of the plane in the home pose, to the side of the disk",
            ),
        ],
        doc: "The edge of a thin disk rolls without slip on a plane, and stays on it: a row on positions and two on velocities.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let [wheel, track] = rolling::partners(arguments, ["wheel", "track"])?;
    let radius = arguments.scalar("radius")?;
    arguments.refuse_not_positive("radius", radius, "a disk has a positive radius")?;
    let axle = arguments.home_axis("axis", 1, wheel.owner)?;
    let normal = match arguments.has("normal") {
        true => arguments.direction("normal")?,
        false => arguments.graph().ground_axes()[2],
    };
    let plane = arguments.axes_along(normal);
    let plane = plane.map(|axis| arguments.fixed_direction(axis, track.owner));
    let graph = arguments.graph();
    let down = steepest(graph, axle, &plane);
    let arm = graph.vector_scale(radius, down);
    let contact = graph.vector_add(wheel.position, arm);
    let gap = graph.vector_sub(contact, track.position);
    let touch = graph.dot(plane[2], gap);
    let slip = rolling::slip(arguments, &wheel, &track, contact);
    let graph = arguments.graph();
    let mut conditions = vec![Condition::position("touch", touch, Dimension::LENGTH)];
    for (suffix, axis) in ["u", "v"].into_iter().zip(plane) {
        conditions.push(Condition {
            suffix: suffix.to_owned(),
            level: Level::Velocity,
            expr: graph.dot(axis, slip),
            dimension: Some(Dimension::VELOCITY),
        });
    }
    let reactions = ["fx", "fy", "fz"].into_iter().enumerate();
    let force = |k: usize| -> Vec<(usize, Expr)> {
        let axes = [plane[2], plane[0], plane[1]].into_iter().enumerate();
        axes.map(|(row, axis)| (row, axis[k])).collect()
    };
    Some(Joint {
        conditions,
        reactions: reactions
            .map(|(k, name)| ReactionComponent {
                name,
                dimension: Dimension::FORCE,
                terms: force(k),
            })
            .collect(),
        points: vec![track, wheel],
        ..Joint::default()
    })
}

/// The direction in the disk that descends to the plane most steeply: −(n − (n · a) a), of unit length.
fn steepest(graph: &mut Graph, axle: Vector, plane: &Axes) -> Vector {
    let part = graph.dot(plane[2], axle);
    let part = graph.vector_scale(part, axle);
    let down = graph.vector_sub(part, plane[2]);
    graph.unit(down)
}
