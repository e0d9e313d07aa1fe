//! A rotational spring and damper in a joint.

use crate::model::arguments::Arguments;
use crate::model::elements::force::Force;
use crate::model::elements::forces::{actuator, characteristic};

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    let others = arguments.joints_that(|traits| traits.turns);
    let otherwise = format!("which has no angle; name a {others}, or use a `Bushing`");
    let joint = actuator::turning(arguments, "joint", &otherwise);
    let characteristic = characteristic::read(arguments, "angle");
    Some(actuator::torsion_spring(
        arguments,
        &joint?,
        characteristic?,
    ))
}
