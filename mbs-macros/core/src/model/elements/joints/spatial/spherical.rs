//! Two points coincide.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::mobilizer::Freedom;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let frames = arguments.own_frames()?;
    // The partners' points as they were given, where they were: ends of slender bars can be merged.
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
