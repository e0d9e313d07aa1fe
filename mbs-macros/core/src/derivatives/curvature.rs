//! Second derivatives of the kinetic energy by positions: ∂²T/∂v∂q = ∂p/∂q, and ∂²T/∂q².

use super::matrix::Matrix;
use super::tangents::{hessian, jacobian};
use crate::model::Rotation;
use crate::symbolic::{Expr, Graph, Length, Symbol};

/// Both.
#[derive(Debug)]
pub(super) struct Curvature {
    /// ∂p/∂q.
    pub momentum: Matrix,
    /// ∂²T/∂q²; within a rotation its rows are the first derivative, and its columns the second one.
    pub energy: Matrix,
}

impl Curvature {
    /// From the derivatives of p and of the slopes ∂T/∂q, entry by entry, or from one pass backwards through T, which is the
    /// shorter in long chains.
    pub(super) fn new(
        graph: &mut Graph,
        kinetic: Expr,
        momentum: &[Expr],
        slopes: &[Expr],
        rotations: &[Rotation],
        mass: &Matrix,
    ) -> Curvature {
        let by_entries = Curvature {
            momentum: jacobian(graph, momentum, Symbol::Coordinate),
            energy: hessian(graph, slopes, rotations),
        };
        if by_entries.momentum.is_empty() && by_entries.energy.is_empty() {
            return by_entries;
        }
        match Curvature::backwards(graph, kinetic) {
            Some(other) if other.beside(graph, mass) < by_entries.beside(graph, mass) => other,
            _ => by_entries,
        }
    }

    /// The operations of both and of M, which implicit steps need with them.
    fn beside(&self, graph: &Graph, mass: &Matrix) -> usize {
        let entries = mass.values().chain(self.momentum.values());
        Length::of(graph, entries.chain(self.energy.values()))
    }

    /// `None` where there are rotations: the directions of one do not commute, and entries are as short.
    fn backwards(graph: &mut Graph, kinetic: Expr) -> Option<Curvature> {
        let hessian = graph.hessian(kinetic, |symbol| {
            matches!(symbol, Symbol::Coordinate(_) | Symbol::Velocity(_))
        })?;
        let (mut momentum, mut energy) = (Matrix::new(), Matrix::new());
        for (pair, entry) in hessian {
            match pair {
                (Symbol::Velocity(i), Symbol::Coordinate(j))
                | (Symbol::Coordinate(j), Symbol::Velocity(i)) => {
                    momentum.insert((i as usize, j as usize), entry);
                }
                (Symbol::Coordinate(i), Symbol::Coordinate(j)) => {
                    energy.insert((i as usize, j as usize), entry);
                    energy.insert((j as usize, i as usize), entry);
                }
                _ => {}
            }
        }
        Some(Curvature { momentum, energy })
    }
}
