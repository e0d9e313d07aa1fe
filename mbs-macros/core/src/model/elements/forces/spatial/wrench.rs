//! A force and a torque on a point of a body.

use crate::model::arguments::Arguments;
use crate::model::elements::force::{Force, ForceElement};
use crate::model::elements::forces::axes::force_in;
use crate::model::geometry::Owner;

pub(super) fn read(arguments: &mut Arguments) -> Option<Force> {
    let on = arguments.point("on")?;
    let name = arguments.owner_name(on.owner);
    if on.owner == Owner::Ground {
        return arguments.fail(
            "on",
            "a wrench on the ground does nothing; apply it to a moving point",
        );
    }
    if arguments.is_particle(on.owner) {
        return arguments.fail(
            "on",
            format!("`{name}` is a particle: a torque cannot turn it; use `Force`"),
        );
    }
    if arguments.has("torque") && arguments.is_slender(on.owner) {
        return arguments.fail(
            "on",
            format!("`{name}` is a slender bar and takes no torque: it has no inertia about itself, and the part along it would be lost; give it `radius =` or `inertia =`, or use `Force`"),
        );
    }
    if !arguments.has("force") && !arguments.has("torque") {
        return arguments.fail(
            "",
            "this wrench does nothing; give it `force =` or `torque =`",
        );
    }
    let zero = arguments.graph().zero_vector();
    let mut component = |field: &str| match arguments.has(field) {
        true => arguments.vector(field),
        false => Some(zero),
    };
    let (force, torque) = (component("force")?, component("torque")?);
    let axes = force_in(arguments)?;
    Some(Force {
        element: ForceElement::Wrench {
            on: on.clone(),
            force,
            torque: Some(torque),
            axes,
        },
        points: vec![on],
        owners: Vec::new(),
    })
}
