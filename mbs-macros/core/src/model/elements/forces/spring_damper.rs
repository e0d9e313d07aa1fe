//! A spring and damper between two points.

use super::characteristic;
use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement};

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let characteristic = characteristic::read(arguments, "length");
    let (parent, child) = (parent?, child?);
    if parent.owner == child.owner {
        let owner = arguments.owner_name(parent.owner);
        return arguments.fail(
            "child",
            format!("both points belong to `{owner}`: the element cannot change its length"),
        );
    }
    Some(Force {
        element: ForceElement::Spring {
            from: parent.position,
            to: child.position,
            characteristic: characteristic?,
        },
        points: vec![parent, child],
        owners: Vec::new(),
    })
}
