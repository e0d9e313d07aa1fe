//! Tangents of forces: Jacobians without their structural zeros.

use super::curvature::Curvature;
use super::matrix::Matrix;
use crate::equations::ForceParts;
use crate::model::Rotation;
use crate::symbolic::{Expr, Graph, Length, Symbol};
use std::collections::BTreeMap;

/// Below this number of operations tangents are derived in two ways.
const SHORT: usize = 2000;

/// The tangents of a vector of forces.
#[derive(Debug)]
pub struct Tangents {
    /// By q.
    pub by_position: Matrix,
    /// By v.
    pub by_velocity: Matrix,
}

/// The forces of inertia.
pub(super) struct Inertial<'a> {
    /// p × ω of rotations.
    pub turning: &'a [Expr],
    /// ∂p/∂q and ∂²T/∂q².
    pub curvature: &'a Curvature,
}

impl Tangents {
    pub(super) fn of(graph: &mut Graph, forces: &[Expr]) -> Tangents {
        Tangents {
            by_position: jacobian(graph, forces, Symbol::Coordinate),
            by_velocity: jacobian(graph, forces, Symbol::Velocity),
        }
    }

    /// These, or the Jacobians of the forces as they are, whichever is shorter beside what is computed with them. (Where they
    /// are long, these are.)
    pub(super) fn or_direct(self, graph: &mut Graph, forces: &[Expr], beside: &Matrix) -> Tangents {
        let shared = self.length(graph, beside);
        if shared > SHORT {
            return self;
        }
        let direct = Tangents::of(graph, forces);
        match direct.length(graph, beside) < shared {
            true => direct,
            false => self,
        }
    }

    /// Counting stops where they are long.
    fn length(&self, graph: &Graph, beside: &Matrix) -> usize {
        let mut length = Length::default();
        let matrices = [&self.by_position, &self.by_velocity, beside];
        for &entry in matrices.into_iter().flat_map(Matrix::values) {
            length.add(graph, entry);
            if length.operations() > SHORT {
                break;
            }
        }
        length.operations()
    }

    /// Those of f = loads − ∂V/∂q: ∂²V/∂q² is symmetric, and its pairs are derived once.
    pub(super) fn of_parts(
        graph: &mut Graph,
        parts: &ForceParts,
        rotations: &[Rotation],
    ) -> Tangents {
        let loads = Tangents::of(graph, &parts.loads);
        let stiffness = hessian(graph, &parts.potential_slopes, rotations);
        Tangents {
            by_position: total(graph, [(-1.0, &stiffness), (1.0, &loads.by_position)]),
            by_velocity: loads.by_velocity,
        }
    }

    /// Those of F = f + ∂T/∂q + p × ω from those of f, of `turning` = p × ω, and of p: ∂²T/∂q² is symmetric, and
    /// ∂/∂v ∂T/∂q = (∂p/∂q)ᵀ.
    pub(super) fn with_inertial(&self, graph: &mut Graph, inertial: &Inertial) -> Tangents {
        let turning = Tangents::of(graph, inertial.turning);
        let Curvature { momentum, energy } = inertial.curvature;
        let entries = momentum.iter();
        let transposed: Matrix = entries.map(|(&(i, j), &entry)| ((j, i), entry)).collect();
        let sum = |graph: &mut Graph, matrices: [&Matrix; 3]| {
            total(graph, matrices.map(|matrix| (1.0, matrix)))
        };
        Tangents {
            by_position: sum(graph, [&self.by_position, energy, &turning.by_position]),
            by_velocity: sum(
                graph,
                [&self.by_velocity, &transposed, &turning.by_velocity],
            ),
        }
    }
}

/// ∂values/∂(symbols made by `by`).
pub(super) fn jacobian(graph: &mut Graph, values: &[Expr], by: impl Fn(u32) -> Symbol) -> Matrix {
    let mut matrix = Matrix::new();
    for (row, &value) in values.iter().enumerate() {
        for symbol in graph.directions([value]) {
            let column = match symbol {
                Symbol::Coordinate(i) | Symbol::Velocity(i) if by(i) == symbol => i as usize,
                _ => continue,
            };
            put(graph, &mut matrix, (row, column), |graph| {
                graph.derivative(value, symbol)
            });
        }
    }
    matrix
}

/// ∂slopes/∂q, where slopes are ∂/∂q of a scalar: symmetric but within a rotation, whose directions do not commute. Each
/// pair of entries is derived once.
pub(super) fn hessian(graph: &mut Graph, slopes: &[Expr], rotations: &[Rotation]) -> Matrix {
    let turn = |i: usize| {
        let mut turns = rotations.iter();
        turns.position(|rotation| (rotation.velocity..rotation.velocity + 3).contains(&i))
    };
    let mut matrix = Matrix::new();
    for (row, &slope) in slopes.iter().enumerate() {
        for symbol in graph.directions([slope]) {
            let Symbol::Coordinate(column) = symbol else {
                continue;
            };
            let column = column as usize;
            let is_mirrored = turn(row).is_none() || turn(row) != turn(column);
            if is_mirrored && column < row {
                continue;
            }
            let derivative = |graph: &mut Graph| graph.derivative(slope, symbol);
            put(graph, &mut matrix, (row, column), derivative);
            if let (true, Some(&entry)) = (is_mirrored, matrix.get(&(row, column))) {
                matrix.insert((column, row), entry);
            }
        }
    }
    matrix
}

fn put(
    graph: &mut Graph,
    matrix: &mut Matrix,
    place: (usize, usize),
    entry: impl FnOnce(&mut Graph) -> Expr,
) {
    let entry = entry(graph);
    if !graph.is_zero(entry) {
        matrix.insert(place, entry);
    }
}

/// The sum of matrices, each with a factor.
fn total<const COUNT: usize>(graph: &mut Graph, matrices: [(f64, &Matrix); COUNT]) -> Matrix {
    let mut terms: BTreeMap<(usize, usize), Vec<(Expr, f64)>> = BTreeMap::new();
    for (factor, matrix) in matrices {
        for (&place, &entry) in matrix {
            terms.entry(place).or_default().push((entry, factor));
        }
    }
    let mut matrix = Matrix::new();
    for (place, terms) in terms {
        put(graph, &mut matrix, place, |graph| graph.linear(0.0, &terms));
    }
    matrix
}
