//! The one table of the language: kinds, their fields, defaults, dimensions and documentation.
//!
//! It drives the checks of arguments, the hints in error messages and the reference page of the book.

mod common;
mod kind;
mod planar;
mod spatial;

pub use kind::{Absent, Expects, Field, Group, Kind, World};

impl World {
    /// The entry `world:`.
    pub fn kind(self) -> &'static Kind {
        match self {
            World::Planar => &planar::WORLD,
            World::Spatial => &spatial::WORLD,
        }
    }

    /// The kinds that belong to this world alone.
    pub fn own_kinds(self) -> &'static [Kind] {
        match self {
            World::Planar => planar::KINDS,
            World::Spatial => spatial::KINDS,
        }
    }
}

/// Names that no entry may take.
pub const RESERVED: &[&str] = &["ground", "t", "X", "Y", "Z", "pi"];

/// The kinds that all worlds share.
pub fn common_kinds() -> &'static [Kind] {
    common::KINDS
}

/// The kind of this name, in one world.
pub fn kind(world: World, name: &str) -> Option<&'static Kind> {
    let mut kinds = common::KINDS.iter().chain(world.own_kinds());
    kinds.find(|kind| kind.name == name)
}

/// The kind of this name, in any world.
pub fn any_kind(name: &str) -> Option<&'static Kind> {
    World::ALL.into_iter().find_map(|world| kind(world, name))
}

/// The names of all kinds, each once.
pub fn names() -> impl Iterator<Item = &'static str> + Clone {
    let planar = World::Planar.own_kinds().iter();
    let spatial = World::Spatial.own_kinds().iter();
    let new = spatial.filter(|kind| {
        World::Planar
            .own_kinds()
            .iter()
            .all(|other| other.name != kind.name)
    });
    common::KINDS
        .iter()
        .chain(planar)
        .chain(new)
        .map(|kind| kind.name)
}

/// The world of this name.
pub fn world(name: &str) -> Option<World> {
    World::ALL
        .into_iter()
        .find(|world| world.kind().name == name)
}
