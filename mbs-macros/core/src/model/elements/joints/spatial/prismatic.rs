//! The child slides along the axis and does not turn.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::mobilizer::Freedom;
use crate::schema::spatial::{AT, AXIS, CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Prismatic",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT, AXIS],
        doc: "The child slides along the axis and does not turn: 5 rows. It has `stroke` and `speed`.",
        joint: Some(JointTraits {
            slides: true,
            carries: true,
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    // p_x · d = p_y · d = 0, and all axes stay square to the others.
    let joint = Builder::new(arguments.graph(), &frames)
        .on_plane(0)
        .on_plane(1)
        .parallel()
        .square(0, 1)
        .finish();
    Some(Joint {
        mobilizer: Some(frames.mobilizer([Freedom::Slide(2)])),
        ..joint
    })
}
