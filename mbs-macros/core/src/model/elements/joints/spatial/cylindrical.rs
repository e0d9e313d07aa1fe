//! The child slides along the axis and turns about it.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::mobilizer::Freedom;
use crate::schema::spatial::{AT, AXIS, CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Cylindrical",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT, AXIS],
        doc: "The child slides along the axis and turns about it: 4 rows. It has `angle`, `rate`, `stroke` and `speed`.",
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

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    // p_x · d = p_y · d = 0 and z_p · c_y = z_p · c_x = 0.
    let joint = Builder::new(arguments.graph(), &frames)
        .on_plane(0)
        .on_plane(1)
        .parallel()
        .finish();
    Some(Joint {
        mobilizer: Some(frames.mobilizer([Freedom::Slide(2), Freedom::Turn(None)])),
        ..joint
    })
}
