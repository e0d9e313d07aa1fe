//! The child slides in the plane across the axis and turns about the axis.

use super::builder::Builder;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::mobilizer::Freedom;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
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
