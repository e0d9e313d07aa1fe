//! A force on a point, or in a joint.

use super::actuator;
use super::axes::force_in;
use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement};
use crate::model::geometry::Owner;

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    if arguments.names_joint("on") {
        return actuator::force(arguments);
    }
    let (on, value) = (arguments.point("on"), arguments.vector("value"));
    let (on, value) = (on?, value?);
    if on.owner == Owner::Ground {
        return arguments.fail(
            "on",
            "a force on the ground does nothing; apply it to a moving point",
        );
    }
    let axes = force_in(arguments)?;
    Some(Force {
        element: ForceElement::Wrench {
            on: on.clone(),
            force: value,
            torque: None,
            axes,
        },
        points: vec![on],
        owners: Vec::new(),
    })
}
