//! The child slides along the axis and does not turn.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::mobilizer::Freedom;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
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
