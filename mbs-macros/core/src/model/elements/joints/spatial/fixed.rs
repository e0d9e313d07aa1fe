//! The child neither moves nor turns against the parent.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
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
