//! Eliminated rows: a holonomic row that is affine in the coordinates, with constant coefficients, gives one of them in
//! terms of the others. Row and coordinate are eliminated. As the velocities have the same coefficients, a constant M
//! stays constant.
//!
//! How they are found: see `solve`.

use super::elements::JointEntry;
use super::resolver::Resolver;
use crate::symbolic::{Affine, Expr, Graph, Substitution, Symbol};

/// The rows that were solved, with the coordinates that followed from them.
#[derive(Debug, Default)]
pub struct Solved {
    /// Each row: its joint, and its index among the rows of the joint.
    pub rows: Vec<(String, usize)>,
    /// As many coordinates.
    pub coordinates: Vec<SolvedCoordinate>,
    /// Local coordinates in terms of those that stand for a joined point, before rows were solved.
    pub merged: Substitution,
}

/// A coordinate that follows from others.
#[derive(Debug)]
pub struct SolvedCoordinate {
    /// The local coordinate.
    pub local: u32,
    /// Its value in terms of those that remain.
    pub value: Affine,
    /// Its derivatives with respect to the residuals of the eliminated rows, in local coordinates.
    pub answers: Vec<Expr>,
    /// By how much its own guesses of position and velocity exceed those that follow.
    pub gap: [Expr; 2],
}

impl Solved {
    /// The index of a row among the solved ones.
    pub fn position(&self, joint: &str, slot: usize) -> Option<usize> {
        let mut rows = self.rows.iter();
        rows.position(|(name, index)| name == joint && *index == slot)
    }

    /// The joint of each row.
    pub fn joints(&self) -> Vec<String> {
        self.rows.iter().map(|(joint, _)| joint.clone()).collect()
    }

    /// The value of a local coordinate that follows from others.
    pub(super) fn value(&self, local: u32) -> Option<&Affine> {
        let mut coordinates = self.coordinates.iter();
        let solved = coordinates.find(|solved| solved.local == local);
        solved.map(|solved| &solved.value)
    }
}

pub(super) fn local_symbols(local: u32) -> [Symbol; 3] {
    [
        Symbol::LocalPosition(local),
        Symbol::LocalVelocity(local),
        Symbol::LocalAcceleration(local),
    ]
}

/// Position, velocity and acceleration of a coordinate that follows from others, whose symbols are given by `symbols`.
pub(super) fn combination(
    graph: &mut Graph,
    value: &Affine,
    symbols: impl Fn(u32) -> [Symbol; 3],
) -> [Expr; 3] {
    let zero = graph.zero();
    let mut sums = [value.constant, zero, zero];
    for (&symbol, &coefficient) in &value.terms {
        if let Symbol::LocalPosition(local) = symbol {
            for (sum, symbol) in sums.iter_mut().zip(symbols(local)) {
                let term = graph.symbol(symbol);
                let term = graph.mul(coefficient, term);
                *sum = graph.add(*sum, term);
            }
        }
    }
    sums
}

/// A sentence for each joint whose rows were solved.
pub(super) fn describe(
    resolver: &mut Resolver,
    joints: &[JointEntry],
    solved: &Solved,
    sentences: &mut Vec<String>,
) {
    for element in joints {
        let pairs = solved.rows.iter().zip(&solved.coordinates);
        let own = pairs.filter(|((joint, _), _)| *joint == element.name);
        let names: Vec<String> = own
            .map(|(_, coordinate)| resolver.locals[coordinate.local as usize].name.clone())
            .collect();
        let all = element.joint.conditions.len();
        let joint = &element.name;
        sentences.push(match (names.as_slice(), all) {
            ([], _) => continue,
            ([one], 1) => {
                format!("`{joint}`: {one} follows from its row, one coordinate and one row saved")
            }
            ([one], _) => format!(
                "`{joint}`: {one} follows from one of its rows, one coordinate and one row saved"
            ),
            (several, _) => format!(
                "`{joint}`: {} follow from its rows, {} coordinates and as many rows saved",
                several.join(", "),
                several.len()
            ),
        });
    }
}
