//! Two points coincide, and the partners turn about one axis.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::mobilizer::Freedom;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
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
