//! A rack moves as a pinion turns.

use super::gear::turning;
use super::{Joint, Relation};
use crate::model::{Arguments, Dimension};

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
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
    Some(Box::new(Relation {
        owners: Relation::owners([&pinion, &rack]),
        first: arguments.joint_angle(&pinion),
        second: arguments.stroke(&rack),
        ratio: radius?,
        offset: offset?,
        unit: Dimension::LENGTH,
        reaction: ("force", Dimension::FORCE),
    }))
}
