//! The child slides in the plane across the axis and turns about the axis.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::mobilizer::Freedom;
use crate::schema::spatial::{AT, AXIS, CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Planar",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT, AXIS],
        doc: "The child slides in the plane across the axis and turns about the axis: 3 rows. It has `angle` and `rate`.",
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
    // p_z · d = 0 and z_p · c_y = z_p · c_x = 0.
    let joint = Builder::new(arguments.graph(), &frames)
        .on_plane(2)
        .parallel()
        .finish();
    Some(Joint {
        mobilizer: Some(frames.mobilizer([
            Freedom::Slide(0),
            Freedom::Slide(1),
            Freedom::Turn(None),
        ])),
        ..joint
    })
}
