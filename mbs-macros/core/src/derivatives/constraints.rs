//! The rows at velocity and acceleration level.

use super::matrix::Matrix;
use super::tangents;
use crate::equations::Row;
use crate::symbolic::{Expr, Graph, Symbol};

/// A, b, Ȧ and γ.
#[derive(Debug)]
pub(crate) struct RowDerivatives {
    /// A.
    pub jacobian: Matrix,
    /// b of φ̇ = A v + b.
    pub rheonomic: Vec<Expr>,
    /// Ȧ.
    pub jacobian_rate: Matrix,
    /// γ of A v̇ + γ = 0.
    pub convective: Vec<Expr>,
}

/// A of holonomic rows alone.
pub(crate) fn holonomic(graph: &mut Graph, rows: &[Row]) -> RowDerivatives {
    let rows: Vec<Expr> = rows.iter().map(|row| row.expr).collect();
    RowDerivatives {
        jacobian: tangents::jacobian(graph, &rows, Symbol::Coordinate),
        rheonomic: Vec::new(),
        jacobian_rate: Matrix::new(),
        convective: Vec::new(),
    }
}

/// Derives those of all rows.
pub(crate) fn derive(graph: &mut Graph, rows: &[Row]) -> RowDerivatives {
    let mut derived = RowDerivatives {
        jacobian: Matrix::new(),
        rheonomic: Vec::new(),
        jacobian_rate: Matrix::new(),
        convective: Vec::new(),
    };
    for (index, row) in rows.iter().enumerate() {
        let by = |holonomic: bool| {
            if holonomic {
                Symbol::Coordinate
            } else {
                Symbol::Velocity
            }
        };
        let entries = tangents::jacobian(graph, &[row.expr], by(row.kind.is_holonomic()));
        let mut velocity_terms = Vec::new();
        for (&(_, column), &entry) in &entries {
            let velocity = graph.symbol(Symbol::Velocity(column as u32));
            velocity_terms.push(graph.mul(entry, velocity));
            derived.jacobian.insert((index, column), entry);
            let rate = rate_at_constant_velocity(graph, entry);
            if !graph.is_zero(rate) {
                derived.jacobian_rate.insert((index, column), rate);
            }
        }
        let linear = graph.sum(velocity_terms);
        let rheonomic = match row.kind.is_holonomic() {
            true => graph.derivative(row.expr, Symbol::Time),
            // ψ̇ − N v, evaluated where v is zero: exact, since ψ̇ is affine.
            false => graph.without_velocities(row.expr),
        };
        let rate = graph.add(linear, rheonomic);
        derived
            .convective
            .push(rate_at_constant_velocity(graph, rate));
        derived.rheonomic.push(rheonomic);
    }
    derived
}

/// d/dt with v̇ = 0.
fn rate_at_constant_velocity(graph: &mut Graph, expr: Expr) -> Expr {
    let mut terms = Vec::new();
    for symbol in graph.directions([expr]) {
        let rate = match symbol {
            Symbol::Coordinate(i) => graph.symbol(Symbol::Velocity(i)),
            Symbol::Time => graph.one(),
            _ => continue,
        };
        let slope = graph.derivative(expr, symbol);
        terms.push(graph.mul(slope, rate));
    }
    graph.sum(terms)
}
