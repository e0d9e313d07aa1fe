//! What to write instead of what belongs to the other world.

use crate::schema::{Kind, World};

/// An argument that the kind does not have in this world.
pub(super) fn argument(world: World, kind: &Kind, argument: &str) -> Option<&'static str> {
    if kind.traits().arguments_elsewhere.contains(&argument) {
        return Some("in the plane a joint is given by a point of each partner, such as `crank.b`");
    }
    Some(match (world, kind.name, argument) {
        (World::Spatial, "Body", "angle") => {
            "in space an orientation is `orientation = turn(axis, angle)`"
        }
        (World::Spatial, "Body" | "Bar", "rate") => {
            "in space it is the vector `angular_velocity = [x, y, z]`"
        }
        (World::Spatial, "Bar", "angle") => {
            "in space a bar is placed by its ends, `from =` and `to =`"
        }
        (World::Spatial, "Bar" | "Body", "frame") => {
            "in space only particles follow coordinates, by `position =`"
        }
        (World::Planar, "Body", "orientation") => "in the plane it is the number `angle =`",
        (World::Planar, "Body" | "Bar", "angular_velocity") => {
            "in the plane it is the number `rate =`"
        }
        (World::Planar, "Bar", "radius" | "inertia") => {
            "in the plane bars are slender; use a `Body` for others"
        }
        _ => return None,
    })
}

/// A kind that this world does not have.
pub(super) fn kind(world: World, kind: &Kind) -> &'static str {
    match (world, kind.traits().elsewhere, kind.name) {
        (World::Planar, "", "Wrench") => "use `Force` and `Torque`, or write `world: Spatial(…)`",
        (World::Planar, "", "Bushing") => {
            "use `SpringDamper` and `TorsionSpring`, or write `world: Spatial(…)`"
        }
        (World::Planar, "", _) => "write `world: Spatial(…)` for it",
        (World::Spatial, "", _) => "write `world: Planar(…)` for it",
        (_, advice, _) => advice,
    }
}
