//! A torque on a part, with its reaction on another, or in a joint.

use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement};
use crate::model::elements::forces::actuator;
use crate::model::geometry::Owner;

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    if arguments.names_joint("on") {
        return actuator::torque(arguments);
    }
    let on = arguments.part("on")?;
    let value = arguments.vector("value")?;
    let mut other = |field: &str| match arguments.has(field) {
        true => arguments.part(field),
        false => Some(Owner::Ground),
    };
    let (from, axes) = (other("from")?, other("axes")?);
    if on == from {
        return arguments.fail("on", match on {
            Owner::Ground => "a torque on the ground does nothing; apply it to a part",
            Owner::Part(_) => "a torque of a part on itself does nothing; name another part in `from`, or leave it out",
        });
    }
    for (field, owner) in [("on", on), ("from", from), ("axes", axes)] {
        let name = arguments.owner_name(owner);
        if arguments.is_particle(owner) {
            return arguments.fail(
                field,
                format!("`{name}` is a particle: a torque cannot turn it; use a `Body`, or a `Bar` with `radius =`"),
            );
        }
        if field != "axes" && arguments.is_slender(owner) {
            return arguments.fail(
                field,
                format!("`{name}` is a slender bar and takes no torque: it has no inertia about itself, and the part along it would be lost; give it `radius =` or `inertia =`"),
            );
        }
        if arguments.is_slender(owner) {
            return arguments.fail(
                field,
                format!("`{name}` is a slender bar, which has no axes; use a `Body`, or a `Bar` with `radius =`"),
            );
        }
    }
    Some(Force {
        points: Vec::new(),
        owners: vec![on, from],
        element: ForceElement::Torque {
            between: [on, from],
            torque: value,
            axes,
        },
    })
}
