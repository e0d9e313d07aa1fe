//! A point stays on a plane that is fixed in another part.

use super::sliding_point::{self, held_across};
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "PointOnPlane",
        group: Group::Joint,
        fields: &[
            positional(
                "point",
                Expects::Point,
                Absent::Required,
                "the point that slides; reactions are the forces on it",
            ),
            positional(
                "plane",
                Expects::Point,
                Absent::Required,
                "a point of the plane",
            ),
            field(
                "normal",
                Expects::Axis,
                Absent::Assumed("Z"),
                "normal of the plane in the home pose, in the ground's axes",
            ),
        ],
        doc: "A point stays on a plane that is fixed in another part: 1 row.",
        joint: Some(JointTraits {
            elsewhere: "use `PointOnLine`, or write `world: Spatial(…)`",
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (point, plane) = sliding_point::points(arguments, "plane")?;
    let normal = arguments.home_axis("normal", 2, plane.owner)?;
    // n · (point − plane) = 0; λ n is the force on the point.
    let normals = [("", normal)];
    Some(held_across(arguments.graph(), point, plane, &normals))
}
