//! Force elements as they are declared, one file each. Those of one world are in `planar` and `spatial`.

mod actuator;
mod axes;
mod characteristic;
mod dimensions;
mod force;
mod friction;
mod planar;
mod spatial;
mod spring_damper;
mod stop;

use super::force::Force;
use crate::model::arguments::Arguments;
use crate::schema::World;

/// Reads a force element.
pub(in crate::model) fn read(kind: &str, arguments: &mut Arguments) -> Option<Force> {
    match kind {
        "SpringDamper" => spring_damper::read(arguments),
        "Force" => force::read(arguments),
        "Stop" => stop::read(arguments),
        "Friction" => friction::read(arguments),
        _ => match arguments.world() {
            World::Planar => planar::read(kind, arguments),
            World::Spatial => spatial::read(kind, arguments),
        },
    }
}
