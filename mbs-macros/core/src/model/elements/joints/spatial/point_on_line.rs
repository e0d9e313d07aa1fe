//! A point stays on a line that is fixed in another part.

use super::sliding_point::{self, held_across};
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "PointOnLine",
        group: Group::Joint,
        fields: &[
            positional(
                "point",
                Expects::Point,
                Absent::Required,
                "the point that slides; reactions are the forces on it",
            ),
            positional(
                "line",
                Expects::Point,
                Absent::Required,
                "a point of the line",
            ),
            field(
                "axis",
                Expects::Axis,
                Absent::Assumed("X"),
                "direction of the line in the home pose, in the ground's axes",
            ),
        ],
        doc: "A point stays on a line that is fixed in another part: 2 rows.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (point, line) = sliding_point::points(arguments, "line")?;
    let axis = match arguments.has("axis") {
        true => arguments.direction("axis")?,
        false => arguments.graph().ground_axes()[0],
    };
    let [x, y, _] = arguments.axes_along(axis);
    let normals = [x, y].map(|normal| arguments.fixed_direction(normal, line.owner));
    let [u, v] = normals;
    // n · (point − line) = 0 for two directions across the line; λ n is the force on the point.
    let normals = [("u", u), ("v", v)];
    Some(held_across(arguments.graph(), point, line, &normals))
}
