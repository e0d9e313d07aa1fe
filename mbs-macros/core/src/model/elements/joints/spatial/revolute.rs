//! Two points coincide, and the partners turn about one axis.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::mobilizer::Freedom;
use crate::schema::spatial::{AT, AXIS, CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Revolute",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT, AXIS],
        doc: "Two points coincide and the partners turn about one axis: 5 rows. It has `angle` and `rate`.",
        joint: Some(JointTraits {
            turns: true,
            carries: true,
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    // d = 0 and z_p · c_y = z_p · c_x = 0.
    let joint = Builder::new(arguments.graph(), &frames)
        .coincide()
        .parallel()
        .finish();
    Some(Joint {
        mobilizer: Some(frames.mobilizer([Freedom::Turn(None)])),
        coincident: Some(frames.origins()),
        ..joint
    })
}
