//! The rows at velocity and acceleration level.
//!
//! | quantity | entry by entry | otherwise |
//! |---|---|---|
//! | A | forwards, once for each coordinate | backwards, once for each row |
//! | γ | the rate of A v + b, coordinate by coordinate | the rate of the rate of φ, in two passes forwards |
//!
//! A row that closes a loop of n bodies by the angles of its joints has n entries, each of which has n derivatives. The
//! passes take a few times the operations of φ instead; short rows are shorter entry by entry.

use super::matrix::Matrix;
use super::tangents;
use crate::equations::Row;
use crate::symbolic::{Expr, Graph, Length, Symbol};

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
    RowDerivatives {
        jacobian: forwards(graph, rows),
        rheonomic: Vec::new(),
        jacobian_rate: Matrix::new(),
        convective: Vec::new(),
    }
}

/// Derives those of all rows.
pub(crate) fn derive(graph: &mut Graph, rows: &[Row]) -> RowDerivatives {
    let forwards = forwards(graph, rows);
    let rheonomic: Vec<Expr> = rows.iter().map(|row| rheonomic(graph, row)).collect();
    let by_entries = convective_by_entries(graph, &forwards, &rheonomic);
    let backwards = backwards(graph, rows, &forwards);
    let along = convective_along(graph, rows);
    // Explicit methods need A and γ together.
    let length = |jacobian: &Matrix, convective: &[Expr]| {
        Length::of(graph, jacobian.values().chain(convective))
    };
    let mut shortest = (&forwards, &by_entries);
    let mut least = worth_less_than(length(&forwards, &by_entries));
    for way in [
        (&backwards, &by_entries),
        (&forwards, &along),
        (&backwards, &along),
    ] {
        let length = length(way.0, way.1);
        if length < least {
            (shortest, least) = (way, length);
        }
    }
    let (jacobian, convective) = (shortest.0.clone(), shortest.1.clone());
    RowDerivatives {
        jacobian_rate: rate(graph, &jacobian),
        jacobian,
        rheonomic,
        convective,
    }
}

/// The number of operations below which something replaces what has so many: programs have sums in common that
/// [`Length`] does not see, so that a small difference decides nothing.
fn worth_less_than(length: usize) -> usize {
    length - length / 10
}

/// The symbol by which a row has its entry of this column.
fn direction(row: &Row, column: u32) -> Symbol {
    match row.kind.is_holonomic() {
        true => Symbol::Coordinate(column),
        false => Symbol::Velocity(column),
    }
}

/// A: ∂φ/∂q and ∂ψ̇/∂v, entry by entry.
fn forwards(graph: &mut Graph, rows: &[Row]) -> Matrix {
    let mut jacobian = Matrix::new();
    for (index, row) in rows.iter().enumerate() {
        let entries = tangents::jacobian(graph, &[row.expr], |column| direction(row, column));
        jacobian.extend(
            entries
                .into_iter()
                .map(|((_, j), entry)| ((index, j), entry)),
        );
    }
    jacobian
}

/// A, row by row; entries that are zero by their form are not in `forwards` and are left out.
fn backwards(graph: &mut Graph, rows: &[Row], forwards: &Matrix) -> Matrix {
    let mut jacobian = Matrix::new();
    for (index, row) in rows.iter().enumerate() {
        for (symbol, entry) in graph.gradient(row.expr) {
            if let Symbol::Coordinate(column) | Symbol::Velocity(column) = symbol
                && symbol == direction(row, column)
                && forwards.contains_key(&(index, column as usize))
            {
                jacobian.insert((index, column as usize), entry);
            }
        }
    }
    jacobian
}

/// The entry of b.
fn rheonomic(graph: &mut Graph, row: &Row) -> Expr {
    match row.kind.is_holonomic() {
        true => graph.derivative(row.expr, Symbol::Time),
        // ψ̇ − N v, evaluated where v is zero: exact, since ψ̇ is affine.
        false => graph.without_velocities(row.expr),
    }
}

/// γ as d(A v + b)/dt.
fn convective_by_entries(graph: &mut Graph, jacobian: &Matrix, rheonomic: &[Expr]) -> Vec<Expr> {
    let mut terms: Vec<Vec<Expr>> = rheonomic.iter().map(|&b| vec![b]).collect();
    for (&(row, column), &entry) in jacobian {
        let velocity = graph.symbol(Symbol::Velocity(column as u32));
        terms[row].push(graph.mul(entry, velocity));
    }
    let rates = terms.into_iter().map(|terms| {
        let rate = graph.sum(terms);
        rate_at_constant_velocity(graph, rate)
    });
    rates.collect()
}

/// γ as dφ̇/dt with φ̇ = dφ/dt, and as dψ̇/dt.
fn convective_along(graph: &mut Graph, rows: &[Row]) -> Vec<Expr> {
    let exprs: Vec<Expr> = rows.iter().map(|row| row.expr).collect();
    let mut rates = graph.rates_at_constant_velocity(&exprs);
    for (rate, row) in rates.iter_mut().zip(rows) {
        if !row.kind.is_holonomic() {
            *rate = row.expr;
        }
    }
    graph.rates_at_constant_velocity(&rates)
}

/// Ȧ, entry by entry or in one pass, whichever is shorter.
fn rate(graph: &mut Graph, jacobian: &Matrix) -> Matrix {
    let entries: Vec<Expr> = jacobian.values().copied().collect();
    let by_entries: Vec<Expr> = entries
        .iter()
        .map(|&entry| rate_at_constant_velocity(graph, entry))
        .collect();
    let along = graph.rates_at_constant_velocity(&entries);
    let most = worth_less_than(Length::of(graph, &by_entries));
    let rates = match Length::of(graph, &along) < most {
        true => along,
        false => by_entries,
    };
    let places = jacobian.keys().copied().zip(rates);
    places.filter(|&(_, rate)| !graph.is_zero(rate)).collect()
}

/// d/dt with v̇ = 0, coordinate by coordinate.
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
