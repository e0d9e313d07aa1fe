//! A rotational spring and damper in a joint.

use super::{Action, Characteristic, Force};
use crate::model::{Arguments, JointFrames, Owner};
use crate::symbolic::{Expr, Graph};

#[derive(Debug)]
struct TorsionSpring {
    joint: JointFrames,
    angle: Expr,
    rate: Expr,
    characteristic: Characteristic,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    let joint = arguments.joint("joint");
    let characteristic = Characteristic::read(arguments, "angle");
    let joint = joint?;
    if !joint.turns() {
        let (kind, name) = (&joint.kind, &joint.name);
        return arguments.fail(
            "joint",
            format!("`{name}` is a `{kind}`, which has no angle; name a `Revolute` or `Cylindrical`, or use a `Bushing`"),
        );
    }
    Some(Box::new(TorsionSpring {
        angle: arguments.joint_angle(&joint),
        rate: arguments.joint_rate(&joint),
        joint,
        characteristic: characteristic?,
    }))
}

impl Force for TorsionSpring {
    fn action(&self, graph: &mut Graph) -> Action {
        self.characteristic.action(graph, self.angle, self.rate)
    }

    fn owners(&self) -> Vec<Owner> {
        vec![self.joint.parent.point.owner, self.joint.child.point.owner]
    }
}
