//! Jacobians of vectors of expressions, without their structural zeros.

use super::matrix::Matrix;
use crate::symbolic::{Expr, Graph, Symbol};

/// ∂values/∂(symbols made by `by`).
pub(super) fn jacobian(graph: &mut Graph, values: &[Expr], by: impl Fn(u32) -> Symbol) -> Matrix {
    let mut matrix = Matrix::new();
    for (row, &value) in values.iter().enumerate() {
        for symbol in graph.directions([value]) {
            let column = match symbol {
                Symbol::Coordinate(i) | Symbol::Velocity(i) if by(i) == symbol => i as usize,
                _ => continue,
            };
            let entry = graph.derivative(value, symbol);
            if !graph.is_zero(entry) {
                matrix.insert((row, column), entry);
            }
        }
    }
    matrix
}
