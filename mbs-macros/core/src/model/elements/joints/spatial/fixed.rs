//! The child neither moves nor rotates relative to the parent.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::schema::spatial::{AT, CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Fixed",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT],
        doc: "The child neither moves nor turns against the parent: 6 rows.",
        joint: Some(JointTraits {
            carries: true,
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    // d = 0, and all axes stay square to the others.
    let joint = Builder::new(arguments.graph(), &frames)
        .coincide()
        .parallel()
        .square(0, 1)
        .finish();
    Some(Joint {
        mobilizer: Some(frames.mobilizer([])),
        coincident: Some(frames.origins()),
        ..joint
    })
}
