//! The one table of the language: kinds, their fields, defaults, dimensions and documentation.
//!
//! It drives the checks of arguments, the hints in error messages and the reference page of the book.

mod kinds;

use crate::model::Dimension;

pub use kinds::{KINDS, WORLDS};

/// A kind of entry.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// Its name, as written.
    pub name: &'static str,
    /// What it declares.
    pub group: Group,
    /// Its fields; those that may be positional come first, in order.
    pub fields: &'static [Field],
    /// One sentence.
    pub doc: &'static str,
}

/// What an entry declares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// A number or expression.
    Value,
    /// Something with mass, or a coordinate.
    Part,
    /// A condition between two parts.
    Joint,
    /// A condition written as an expression.
    Constraint,
    /// A force element.
    Force,
}

/// A field of a kind.
#[derive(Debug, Clone, Copy)]
pub struct Field {
    /// Its name; a positional field may be given by name, too.
    pub name: &'static str,
    /// Whether it may be given by position.
    pub positional: bool,
    /// What it takes.
    pub expects: Expects,
    /// What happens when it is left out.
    pub default: Absent,
    /// One line.
    pub doc: &'static str,
}

/// What a field takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Expects {
    /// A scalar that is known once the parameters are.
    Known(Dimension),
    /// A scalar of any dimension that is known once the parameters are.
    KnownAny,
    /// Two components known once the parameters are.
    KnownVector(Dimension),
    /// A scalar that may change with time, state and inputs.
    Moving(Dimension),
    /// A scalar of any dimension that may change with time, state and inputs.
    MovingAny,
    /// Two components that may change with time, state and inputs.
    MovingVector(Dimension),
    /// A scalar, a vector, a point, or a list of scalars.
    Anything,
    /// A point.
    Point,
    /// A bar, body, or the ground.
    Part,
    /// `X`, `Y`, or two components in the axes of the second partner.
    Axis,
    /// `Frame([x, y], angle)`.
    Frame,
    /// The path of a function `fn([f64; K]) -> (f64, [f64; K])`: value and partials.
    Law,
    /// A unit, as in `N_per_m`.
    Unit,
    /// `true` or `false`.
    Flag,
}

/// What happens when a field is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Absent {
    /// It may not be.
    Required,
    /// This text describes what is assumed.
    Assumed(&'static str),
}

/// Names that no entry may take.
pub const RESERVED: &[&str] = &["ground", "t", "X", "Y", "Z", "pi"];

/// The kind of this name.
pub fn kind(name: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.name == name)
}

/// The world of this name.
pub fn world(name: &str) -> Option<&'static Kind> {
    WORLDS.iter().find(|kind| kind.name == name)
}
