//! A rack moves as a pinion turns.

use super::relation::{Relation, turning};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "RackPinion",
        group: Group::Joint,
        fields: &[
            positional(
                "pinion",
                Expects::Joint,
                Absent::Required,
                "the joint that turns",
            ),
            positional(
                "rack",
                Expects::Joint,
                Absent::Required,
                "the joint that slides; the reaction is the force along it",
            ),
            field(
                "radius",
                Expects::Known(Dimension::LENGTH),
                Absent::Required,
                "stroke of the rack per radian of the pinion",
            ),
            field(
                "offset",
                Expects::Known(Dimension::LENGTH),
                Absent::Assumed("0"),
                "stroke where the angle is zero",
            ),
        ],
        doc: "A rack moves as a pinion turns: 1 row.",
        joint: Some(JointTraits {
            elsewhere: "use `Coupling`, or write `world: Spatial(…)`",
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (pinion, rack) = (turning(arguments, "pinion"), arguments.joint("rack"));
    let (pinion, rack) = (pinion?, rack?);
    if !rack.slides {
        let (kind, name) = (&rack.kind, &rack.name);
        let others = arguments.joints_that(|traits| traits.slides);
        return arguments.fail(
            "rack",
            format!("`{name}` is a `{kind}`, which has no stroke; name a {others}"),
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
