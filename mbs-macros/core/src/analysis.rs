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
    /// Everything that is computed.
    pub derived: Derived,
    /// Rank and redundant rows near the guess, where a pose could be assembled there.
    pub mobility: Option<Mobility>,
    /// The operations of each function.
    pub program: Program,
    /// The descriptions that were considered; empty where one was asked for.
    pub candidates: Vec<Candidate>,
}

/// A description that was considered.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Which.
    pub formulation: Formulation,
    /// Q.
    pub coordinates: usize,
    /// N.
    pub velocities: usize,
    /// R.
    pub rows: usize,
    /// Rank of the rows near the guess, where a pose could be assembled there.
    pub rank: Option<usize>,
    /// Operations of a step; `None` where the linear algebra alone costs more than a whole step of another.
    pub operations: Option<usize>,
    /// Joints that could carry a part, and close a loop instead.
    pub cut: Vec<String>,
    /// Whether it is the one in use.
    pub taken: bool,
}
