//! A torque on a part, with its reaction on another, or in a joint.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement, Load};
use crate::model::elements::forces::actuator;
use crate::model::geometry::Owner;

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    if arguments.names_joint("on") {
        return actuator::torque(arguments);
    }
    let (on, value) = (arguments.part("on"), arguments.scalar("value"));
    let from = if arguments.has("from") {
        arguments.part("from")?
    } else {
        Owner::Ground
    };
    let (on, value) = (on?, value?);
    if on == from {
        return arguments.fail("on", match on {
            Owner::Ground => "a torque on the ground does nothing; apply it to a part",
            Owner::Part(_) => "a torque of a part on itself does nothing; name another part in `from`, or leave it out",
        });
    }
    for (field, owner) in [("on", on), ("from", from)] {
        if arguments.is_particle(owner) {
            let name = arguments.owner_name(owner);
            return arguments.fail(
                field,
                format!("`{name}` is a particle: a torque cannot turn it; use a `Body` or a `Bar`"),
            );
        }
    }
    let rates = [on, from].map(|owner| arguments.frame(owner).spin[2]);
    let rate = arguments.graph().sub(rates[0], rates[1]);
    Some(Force {
        points: Vec::new(),
        owners: vec![on, from],
        element: ForceElement::Load {
            load: Load { rate, force: value },
            dimension: Some(Dimension::TORQUE),
        },
    })
}
