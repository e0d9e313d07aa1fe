//! A point stays on a line that is fixed in another part.

use super::held::across;
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
                "direction of the line, in the axes of the line's part",
            ),
        ],
        doc: "A point stays on a line that is fixed in another part. It has `stroke` and `speed`: of the point along the line, from the line's point.",
        joint: Some(JointTraits {
            slides: true,
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (point, line) = (arguments.point("point"), arguments.point("line"));
    let (point, line) = (point?, line?);
    if point.owner == line.owner {
        let owner = arguments.owner_name(point.owner);
        return arguments.fail(
            "line",
            format!("the point and the line both belong to `{owner}`"),
        );
    }
    if arguments.is_particle(line.owner) {
        let name = arguments.owner_name(line.owner);
        return arguments.fail(
            "line",
            format!(
                "`{name}` is a particle and has no orientation for a line; use a Body or a Bar"
            ),
        );
    }
    let axis = arguments.axis("axis", line.owner)?;
    // n · (point − line) = 0 with n across the line; λ n is the force on the point.
    Some(across(arguments.graph(), &line, &point, axis, ""))
}
