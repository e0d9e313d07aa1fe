//! What values in parameters have to be. With the defaults the compiler checks it; with others the program does, before a
//! motion starts.

use crate::symbolic::Expr;

/// A condition on an argument that follows from parameters.
#[derive(Debug, Clone)]
pub struct Requirement {
    /// The entry.
    pub entry: String,
    /// The argument.
    pub argument: String,
    /// Its value; of an inertia xx, xy, xz, yy, yz and zz.
    pub values: Vec<Expr>,
    /// What it has to be.
    pub wanted: Wanted,
}

/// What an argument has to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// Zero or positive.
    NotNegative,
    /// Positive, for a reason.
    Positive(&'static str),
    /// The inertia of a body.
    Inertia,
}
