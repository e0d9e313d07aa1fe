//! A rotational spring and damper in a joint.

use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement};
use crate::model::elements::forces::characteristic;

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    let joint = arguments.joint("joint");
    let characteristic = characteristic::read(arguments, "angle");
    let joint = joint?;
    if !joint.turns {
        let (kind, name) = (&joint.kind, &joint.name);
        return arguments.fail(
            "joint",
            format!("`{name}` is a `{kind}`, which has no angle; name a `Revolute` or `Cylindrical`, or use a `Bushing`"),
        );
    }
    let zero = arguments.graph().zero();
    Some(Force {
        points: Vec::new(),
        owners: vec![joint.parent.point.owner, joint.child.point.owner],
        element: ForceElement::TorsionSpring {
            angles: [arguments.joint_angle(&joint), zero],
            rates: [arguments.joint_rate(&joint), zero],
            characteristic: characteristic?,
        },
    })
}
