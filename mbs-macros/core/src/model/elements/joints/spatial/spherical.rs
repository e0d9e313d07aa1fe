//! Two points coincide.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::mobilizer::Freedom;
use crate::schema::spatial::{AT, CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Spherical",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT],
        doc: "Two points coincide: 3 rows. Between ends of slender bars, particles and the ground they are merged: no coordinate and no row.",
        joint: Some(JointTraits {
            holds_orientation: false,
            carries: true,
            elsewhere: "use `Revolute`, or write `world: Spatial(…)`",
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    // The points of the partners, if they were given as points: ends of slender bars can be merged.
    let points = match arguments.has("at") {
        true => None,
        false => arguments.given_points(),
    };
    // d = 0.
    let joint = Builder::new(arguments.graph(), &frames).coincide().finish();
    Some(Joint {
        mobilizer: Some(frames.mobilizer([Freedom::Rotation])),
        coincident: Some(frames.origins()),
        points: match &points {
            Some(points) => points.to_vec(),
            None => joint.points,
        },
        merges: points,
        ..joint
    })
}
