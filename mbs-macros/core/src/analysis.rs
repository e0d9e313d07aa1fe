//! A declaration after stages 2 to 5.

use crate::dag::Program;
use crate::derivatives::Derived;
use crate::mobility::Mobility;
use crate::model::{Formulation, Outline};

/// A declaration after stages 2 to 5.
#[derive(Debug)]
pub struct Analysis {
    /// Names, parts, reductions.
    pub outline: Outline,
    /// The derived quantities.
    pub derived: Derived,
    /// Rank and redundant rows near the guess, if a pose could be assembled there.
    pub mobility: Option<Mobility>,
    /// The operations of each function.
    pub program: Program,
    /// The descriptions that were compared; empty if only the declared one was derived.
    pub candidates: Vec<Candidate>,
}

/// A description that was compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Its name.
    pub formulation: Formulation,
    /// Q.
    pub coordinates: usize,
    /// N.
    pub velocities: usize,
    /// R.
    pub rows: usize,
    /// Rank of the rows near the guess, if a pose could be assembled there.
    pub rank: Option<usize>,
    /// Operations of a step; `None` if the linear algebra alone costs more than a whole step of another
    /// description.
    pub operations: Option<usize>,
    /// Joints that could carry a part, but at which a loop is cut.
    pub cut: Vec<String>,
    /// Whether it is the chosen one.
    pub taken: bool,
}
