//! A force or torque in a joint: on the child along or about the joint's axis, and back on the parent.

use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::force::{Characteristic, Force, ForceElement, Load};
use crate::model::joint_frames::JointFrames;
use crate::symbolic::Expr;

/// A torque in a joint that turns.
pub(super) fn torque(arguments: &mut Arguments) -> Option<Force> {
    refuse_partners(
        arguments,
        "a torque in a joint acts on its child, about its axis, and back on its parent; leave this out",
    )?;
    let joint = turning(
        arguments,
        "on",
        "which does not turn about one axis; name a joint that has `angle`, or a part",
    )?;
    let force = value(arguments, Dimension::TORQUE)?;
    let rate = arguments.joint_rate(&joint);
    Some(acting(&joint, Load { rate, force }, Dimension::TORQUE))
}

/// A force in a joint that slides.
pub(super) fn force(arguments: &mut Arguments) -> Option<Force> {
    refuse_partners(
        arguments,
        "a force in a joint acts on its child, along its axis, and back on its parent; leave this out",
    )?;
    let joint = arguments.joint("on")?;
    if !joint.slides {
        let (kind, name) = (&joint.kind, &joint.name);
        return arguments.fail(
            "on",
            format!("`{name}` is a `{kind}`, which does not slide along one axis; name a joint that has `stroke`, or a point"),
        );
    }
    let force = value(arguments, Dimension::FORCE)?;
    let rate = arguments.joint_speed(&joint);
    Some(acting(&joint, Load { rate, force }, Dimension::FORCE))
}

/// A joint that has an angle; `otherwise` says what to do if it has none.
pub(super) fn turning(
    arguments: &mut Arguments,
    field: &str,
    otherwise: &str,
) -> Option<JointFrames> {
    let joint = arguments.joint(field)?;
    let name = &joint.name;
    if !joint.turns {
        let kind = &joint.kind;
        return arguments.fail(field, format!("`{name}` is a `{kind}`, {otherwise}"));
    }
    if let Some(particle) = arguments.resolver().particle_of(&joint) {
        return arguments.fail(
            field,
            format!("`{name}` has no angle: `{particle}` is a particle and has no orientation; use a `Body` or a `Bar`"),
        );
    }
    Some(joint)
}

/// A rotational spring and damper in a joint that turns.
pub(super) fn torsion_spring(
    arguments: &mut Arguments,
    joint: &JointFrames,
    characteristic: Characteristic,
) -> Force {
    let zero = arguments.graph().zero();
    Force {
        points: Vec::new(),
        owners: joint.owners().to_vec(),
        element: ForceElement::TorsionSpring {
            angles: [arguments.joint_angle(joint), zero],
            rates: [arguments.joint_rate(joint), zero],
            characteristic,
        },
    }
}

fn refuse_partners(arguments: &mut Arguments, message: &str) -> Option<()> {
    let mut fields = ["from", "axes"].into_iter();
    match fields.find(|field| arguments.has(field)) {
        Some(field) => arguments.fail(field, message),
        None => Some(()),
    }
}

/// The scalar along or about the joint's axis.
fn value(arguments: &mut Arguments, expected: Dimension) -> Option<Expr> {
    let syntax = arguments.syntax("value")?;
    let (value, dimension) = arguments.quantity("value")?;
    arguments.check_dimension("value", dimension, expected, Place::of(syntax))?;
    Some(value)
}

fn acting(joint: &JointFrames, load: Load, dimension: Dimension) -> Force {
    Force {
        points: Vec::new(),
        owners: joint.owners().to_vec(),
        element: ForceElement::Load {
            load,
            dimension: Some(dimension),
        },
    }
}
