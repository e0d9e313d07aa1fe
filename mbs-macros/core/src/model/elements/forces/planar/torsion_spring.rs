//! A rotational spring and damper between two parts, or in a joint.

use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement};
use crate::model::elements::forces::{actuator, characteristic};
use crate::symbolic::Expr;

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    if arguments.names_joint("parent") {
        return in_joint(arguments);
    }
    if !arguments.has("child") {
        return arguments.fail(
            "",
            "a torsion spring acts between two parts; name the second, too, or a joint that turns",
        );
    }
    let (parent, child) = (arguments.part("parent"), arguments.part("child"));
    let characteristic = characteristic::read(arguments, "angle");
    let owners = [parent?, child?];
    if owners[0] == owners[1] {
        return arguments.fail(
            "child",
            "a part does not turn against itself; name another part",
        );
    }
    for (field, owner) in ["parent", "child"].into_iter().zip(owners) {
        if arguments.is_particle(owner) {
            let name = arguments.owner_name(owner);
            return arguments.fail(
                field,
                format!("`{name}` is a particle and has no orientation; use a Body or a Bar"),
            );
        }
    }
    let [parent, child] = owners.map(|owner| arguments.frame(owner));
    // Parts with a rotational spring have an angle: see `model::needs_angle`.
    let zero = arguments.graph().zero();
    let angle_of = |angle: Option<Expr>| angle.unwrap_or(zero);
    Some(Force {
        points: Vec::new(),
        owners: owners.to_vec(),
        element: ForceElement::TorsionSpring {
            angles: [angle_of(child.angle), angle_of(parent.angle)],
            rates: [child.spin[2], parent.spin[2]],
            characteristic: characteristic?,
        },
    })
}

fn in_joint(arguments: &mut Arguments) -> Option<Force> {
    if arguments.has("child") {
        return arguments.fail(
            "child",
            "a spring in a joint acts between its two partners; leave this out",
        );
    }
    let others = arguments.joints_that(|traits| traits.turns);
    let otherwise = format!("which has no angle; name a {others}, or two parts");
    let joint = actuator::turning(arguments, "parent", &otherwise);
    let characteristic = characteristic::read(arguments, "angle");
    Some(actuator::torsion_spring(
        arguments,
        &joint?,
        characteristic?,
    ))
}
