//! A rack moves as a pinion turns.

use super::relation::{Relation, turning};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (pinion, rack) = (turning(arguments, "pinion"), arguments.joint("rack"));
    let (pinion, rack) = (pinion?, rack?);
    if !rack.slides() {
        let (kind, name) = (&rack.kind, &rack.name);
        return arguments.fail(
            "rack",
            format!(
                "`{name}` is a `{kind}`, which has no stroke; name a `Prismatic` or `Cylindrical`"
            ),
        );
    }
    let (radius, offset) = (
        arguments.scalar("radius"),
        arguments.scalar_or("offset", 0.0),
    );
    let relation = Relation {
        variables: [arguments.joint_angle(&pinion), arguments.stroke(&rack)],
        joints: [pinion, rack],
        ratio: radius?,
        offset: offset?,
        unit: Dimension::LENGTH,
        reaction: ("force", Dimension::FORCE),
    };
    Some(relation.joint(arguments))
}
