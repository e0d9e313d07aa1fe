//! The one table of the language: kinds, their fields, defaults, dimensions and documentation. Values, parts and forces
//! have their rows here; the row of a joint is in its own file.
//!
//! It drives the checks of arguments, the hints in error messages and the reference page of the book.

pub mod common;
pub mod contact;
mod kind;
mod kinds;
pub mod planar;
pub mod spatial;

pub use kind::{
    Absent, Expects, Field, Group, Initial, JointTraits, Kind, World, field, positional,
};
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

/// Types of Rust that are no items: a mechanism of such a name would take their place in its own module.
pub const PRIMITIVES: &[&str] = &[
    "bool", "char", "f32", "f64", "i8", "i16", "i32", "i64", "i128", "isize", "str", "u8", "u16",
    "u32", "u64", "u128", "usize",
];

/// Endings of the types that a mechanism has beside its own.
pub const SUFFIXES: &[&str] = &["Equations", "Simulation", "Inputs", "Outputs"];

/// The ending of a mechanism's name with which the type of its simulation would be that of another one's fixed steps.
pub const FIXED_STEP: &str = "FixedStep";

/// The world of this name.
pub fn world(name: &str) -> Option<World> {
    World::ALL
        .into_iter()
        .find(|world| world.kind().name == name)
}
