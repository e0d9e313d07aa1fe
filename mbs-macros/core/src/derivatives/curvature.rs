//! Second derivatives of the kinetic energy by positions: ∂²T/∂v∂q = ∂p/∂q, and ∂²T/∂q².

use super::matrix::Matrix;
use super::tangents::{hessian, jacobian};
use crate::model::Rotation;
use crate::symbolic::{Expr, Graph, Length, Symbol};
use std::collections::BTreeMap;

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
        match Curvature::backwards(graph, kinetic) {
            Some(other) if other.beside(graph, mass) < by_entries.beside(graph, mass) => other,
            _ => by_entries,
        }
    }

    /// The operations of both and of M, which implicit steps need with them.
    fn beside(&self, graph: &Graph, mass: &Matrix) -> usize {
        let mut length = Length::default();
        let entries = mass.values().chain(self.momentum.values());
        let entries = entries.chain(self.energy.values());
        entries.for_each(|&entry| length.add(graph, entry));
        length.operations()
    }

    /// The entries of a rotation matrix are variables of their own here, which change along three directions.
    fn backwards(graph: &mut Graph, kinetic: Expr) -> Option<Curvature> {
        let hessian = graph.hessian(kinetic, |symbol| {
            symbol.is_configuration() || matches!(symbol, Symbol::Velocity(_))
        })?;
        let (mut momentum, mut energy) = (Terms::default(), Terms::default());
        for ((a, b), entry) in hessian.entries {
            let [along_a, along_b] = [a, b].map(|symbol| along(graph, symbol));
            match (a, b) {
                (Symbol::Velocity(_), Symbol::Velocity(_)) => {}
                (Symbol::Velocity(i), _) => momentum.add(graph, i, &along_b, entry),
                (_, Symbol::Velocity(i)) => momentum.add(graph, i, &along_a, entry),
                _ => {
                    for (i, by_i) in along_a {
                        let passed = graph.mul(entry, by_i);
                        energy.add(graph, i, &along_b, passed);
                        if a != b {
                            energy.add_transposed(graph, i, &along_b, passed);
                        }
                    }
                }
            }
        }
        for (symbol, slope) in hessian.slopes {
            if let Symbol::Rotation(..) = symbol {
                for (i, by_i) in along(graph, symbol) {
                    for direction in symbol.directions() {
                        let Symbol::Coordinate(j) = direction else {
                            continue;
                        };
                        let second = graph.derivative(by_i, direction);
                        energy.put(i, j, graph.mul(slope, second));
                    }
                }
            }
        }
        Some(Curvature {
            momentum: momentum.sums(graph),
            energy: energy.sums(graph),
        })
    }
}

/// The directions along which a symbol changes, with its derivatives.
fn along(graph: &mut Graph, symbol: Symbol) -> Vec<(u32, Expr)> {
    let expr = graph.symbol(symbol);
    let mut found = Vec::new();
    for direction in symbol.directions() {
        if let Symbol::Coordinate(i) = direction {
            let slope = graph.derivative(expr, direction);
            if !graph.is_zero(slope) {
                found.push((i, slope));
            }
        }
    }
    found
}

/// The terms of a matrix.
#[derive(Default)]
struct Terms(BTreeMap<(usize, usize), Vec<Expr>>);

impl Terms {
    fn put(&mut self, i: u32, j: u32, term: Expr) {
        let place = (i as usize, j as usize);
        self.0.entry(place).or_default().push(term);
    }

    fn add(&mut self, graph: &mut Graph, i: u32, along: &[(u32, Expr)], entry: Expr) {
        for &(j, by_j) in along {
            self.put(i, j, graph.mul(entry, by_j));
        }
    }

    fn add_transposed(&mut self, graph: &mut Graph, i: u32, along: &[(u32, Expr)], entry: Expr) {
        for &(j, by_j) in along {
            self.put(j, i, graph.mul(entry, by_j));
        }
    }

    fn sums(self, graph: &mut Graph) -> Matrix {
        let mut matrix = Matrix::new();
        for (place, terms) in self.0 {
            let entry = graph.sum(terms);
            if !graph.is_zero(entry) {
                matrix.insert(place, entry);
            }
        }
        matrix
    }
}
