//! The one table of the language: kinds, their fields, defaults, dimensions and documentation. Values, parts and forces
//! have their rows here; the row of a joint is in its own file.
//!
//! It drives the checks of arguments, the hints in error messages and the reference page of the book.

pub mod common;
mod kind;
mod kinds;
pub mod planar;
pub mod spatial;

pub use kind::{Absent, Expects, Field, Group, JointTraits, Kind, World, field, positional};
pub use kinds::Kinds;

impl World {
    /// The entry `world:`.
    pub fn kind(self) -> &'static Kind {
        match self {
            World::Planar => &planar::WORLD,
            World::Spatial => &spatial::WORLD,
        }
    }
}

/// Names that no entry may take.
pub const RESERVED: &[&str] = &["ground", "t", "X", "Y", "Z", "pi"];

/// The world of this name.
pub fn world(name: &str) -> Option<World> {
    World::ALL
        .into_iter()
        .find(|world| world.kind().name == name)
}
