//! Functions given by measured values: a polynomial of third degree in each interval.

use super::{Expr, Graph, Node, Number, Symbol};
use std::sync::Arc;

/// Between the knots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Monotone cubic polynomials: the slope is continuous, and there is no overshoot.
    Cubic,
    /// Straight lines.
    Linear,
}

/// Outside the knots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Beyond {
    /// The slope at the end goes on.
    Linear,
    /// The value at the end goes on; cubic polynomials arrive there with slope 0.
    Constant,
    /// The curve is repeated, with the distance of the ends as its period; the values at the ends are the same.
    Periodic,
}

/// A function of one variable: before the first knot, in each interval, and after the last knot a polynomial. Its
/// derivatives and its integral are functions of the same sort.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct Table {
    /// Its number in the declaration.
    pub index: usize,
    /// Its name.
    pub name: String,
    knots: Vec<Number>,
    /// One more than knots: the coefficients of powers 0 to 3 of x minus the knot on the left (of the first piece: minus
    /// the first knot), and the integral from 0 to there.
    pieces: Vec<[Number; 5]>,
    /// Whether the curve between the first and the last knot is repeated.
    pub is_periodic: bool,
    /// What the generated program computes the pieces from, if some of the data are parameters; knots and pieces are then
    /// those of the defaults.
    pub data: Option<TableData>,
}

/// The points of a table, some of whose coordinates are parameters, and what is between and beyond them.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct TableData {
    /// Arguments and values.
    pub points: [Vec<Datum>; 2],
    /// Between the points.
    pub interpolation: Interpolation,
    /// Beyond them.
    pub beyond: Beyond,
}

/// A coordinate of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Datum {
    /// The same for all mechanisms of the type.
    Number(Number),
    /// Given by each mechanism.
    Parameter(Symbol),
}

impl TableData {
    /// The parameters among the coordinates.
    pub fn parameters(&self) -> impl Iterator<Item = Symbol> {
        self.points
            .iter()
            .flatten()
            .filter_map(|datum| match datum {
                Datum::Parameter(symbol) => Some(*symbol),
                Datum::Number(_) => None,
            })
    }
}

/// The order of the integral, as a derivative.
pub const INTEGRAL: i8 = -1;

impl Table {
    /// Through the points (x, y), of which there are at least two, with x increasing.
    pub fn new(
        (index, name): (usize, String),
        x: &[f64],
        y: &[f64],
        interpolation: Interpolation,
        beyond: Beyond,
    ) -> Table {
        let last = x.len() - 1;
        let widths: Vec<f64> = (0..last).map(|k| x[k + 1] - x[k]).collect();
        let secants: Vec<f64> = (0..last).map(|k| (y[k + 1] - y[k]) / widths[k]).collect();
        let slopes = monotone_slopes(&widths, &secants, beyond);
        let mut pieces: Vec<[f64; 5]> = vec![[0.0; 5]];
        for k in 0..last {
            let (h, secant) = (widths[k], secants[k]);
            let [left, right] = [slopes[k], slopes[k + 1]];
            pieces.push(match interpolation {
                Interpolation::Linear => [y[k], secant, 0.0, 0.0, 0.0],
                Interpolation::Cubic => {
                    let square = (3.0 * secant - 2.0 * left - right) / h;
                    let cube = (left + right - 2.0 * secant) / (h * h);
                    [y[k], left, square, cube, 0.0]
                }
            });
        }
        let ends = match (beyond, interpolation) {
            (Beyond::Constant, _) => [0.0; 2],
            (Beyond::Linear, Interpolation::Linear) => [secants[0], secants[last - 1]],
            (Beyond::Periodic, Interpolation::Linear) => [secants[last - 1], secants[0]],
            (_, Interpolation::Cubic) => [slopes[0], slopes[last]],
        };
        pieces[0] = [y[0], ends[0], 0.0, 0.0, 0.0];
        pieces.push([y[last], ends[1], 0.0, 0.0, 0.0]);
        // Integrals from the first knot, and then from 0.
        for k in 0..last {
            pieces[k + 2][4] = evaluate(&pieces[k + 1], widths[k], INTEGRAL);
        }
        let number = |pieces: &[[f64; 5]]| pieces.iter().map(|p| p.map(Number::new)).collect();
        let mut table = Table {
            index,
            name,
            knots: x.iter().copied().map(Number::new).collect(),
            pieces: number(&pieces),
            is_periodic: beyond == Beyond::Periodic,
            data: None,
        };
        let zero = table.value(0.0, INTEGRAL);
        pieces.iter_mut().for_each(|piece| piece[4] -= zero);
        table.pieces = number(&pieces);
        table
    }

    /// With the coordinates of its points as they were declared.
    pub fn with_data(
        self,
        points: [Vec<Datum>; 2],
        interpolation: Interpolation,
        beyond: Beyond,
    ) -> Table {
        let data = TableData {
            points,
            interpolation,
            beyond,
        };
        let varies = data.parameters().next().is_some();
        Table {
            data: varies.then_some(data),
            ..self
        }
    }

    /// The knots.
    pub fn knots(&self) -> impl Iterator<Item = f64> {
        self.knots.iter().map(|x| x.value())
    }

    /// The coefficients of the pieces.
    pub fn pieces(&self) -> impl Iterator<Item = [f64; 5]> {
        self.pieces.iter().map(|piece| piece.map(Number::value))
    }

    /// The function, one of its derivatives, or its integral from 0; the same operations as in `mbs_runtime::generated`.
    pub fn value(&self, x: f64, order: i8) -> f64 {
        let [first, last] = [0, self.knots.len() - 1].map(|k| self.knots[k].value());
        if !self.is_periodic || (first..last).contains(&x) {
            return self.value_between(x, order);
        }
        let period = last - first;
        let periods = ((x - first) / period).floor();
        let value = self.value_between(x - periods * period, order);
        match order {
            INTEGRAL => {
                let area = self.pieces[self.knots.len()][4].value() - self.pieces[1][4].value();
                value + periods * area
            }
            _ => value,
        }
    }

    /// The same without repetition.
    fn value_between(&self, x: f64, order: i8) -> f64 {
        let after = self.knots.partition_point(|knot| knot.value() <= x);
        let from = self.knots[after.saturating_sub(1)].value();
        evaluate(&self.pieces[after].map(Number::value), x - from, order)
    }

    /// The function, one of its derivatives, or its integral in words: `f`, `f'`, `integral of f`.
    pub fn function_name(&self, order: i8) -> String {
        match order {
            INTEGRAL => format!("integral of {}", self.name),
            order => self.name.clone() + &"'".repeat(order as usize),
        }
    }

    /// Whether the slope jumps at a knot; of straight lines between parameters it may.
    pub fn has_kinks(&self) -> bool {
        if let Some(data) = &self.data {
            return data.interpolation == Interpolation::Linear;
        }
        let (knots, pieces) = (Vec::from_iter(self.knots()), Vec::from_iter(self.pieces()));
        (0..knots.len()).any(|k| {
            let width = if k > 0 { knots[k] - knots[k - 1] } else { 0.0 };
            let before = evaluate(&pieces[k], width, 1);
            // Where both slopes vanish the one before is round-off of what the piece has in between.
            let within = if width > 0.0 {
                (evaluate(&pieces[k], width, 0) - pieces[k][0]) / width
            } else {
                0.0
            };
            let size = pieces[k][1].abs() + pieces[k + 1][1].abs() + within.abs();
            (before - pieces[k + 1][1]).abs() > 1e-9 * size
        })
    }

    /// The highest derivative that is not zero everywhere, or may not be with other parameters.
    fn degree(&self) -> i8 {
        match &self.data {
            Some(data) if data.interpolation == Interpolation::Linear => return 1,
            Some(_) => return 3,
            None => {}
        }
        let zero = |power: usize| self.pieces.iter().all(|piece| piece[power].value() == 0.0);
        (1..4).rev().find(|&k| !zero(k)).unwrap_or(0) as i8
    }
}

/// A polynomial, one of its derivatives, or its integral.
fn evaluate(piece: &[f64; 5], h: f64, order: i8) -> f64 {
    let [a, b, c, d, integral] = *piece;
    match order {
        INTEGRAL => integral + h * (a + h * (b / 2.0 + h * (c / 3.0 + h * (d / 4.0)))),
        0 => a + h * (b + h * (c + h * d)),
        1 => b + h * (2.0 * c + h * (3.0 * d)),
        2 => 2.0 * c + h * (6.0 * d),
        3 => 6.0 * d,
        _ => 0.0,
    }
}

/// Slopes at the knots with which cubic polynomials are monotone where the values are (Fritsch and Butland 1984).
fn monotone_slopes(widths: &[f64], secants: &[f64], beyond: Beyond) -> Vec<f64> {
    let count = secants.len();
    let between = |left: usize, right: usize| {
        let (before, after) = (secants[left], secants[right]);
        if before * after <= 0.0 {
            return 0.0;
        }
        let weights = [
            widths[left] + 2.0 * widths[right],
            2.0 * widths[left] + widths[right],
        ];
        (weights[0] + weights[1]) / (weights[0] / before + weights[1] / after)
    };
    let end = |k: usize, next: usize| match (beyond, count) {
        (Beyond::Constant, _) => 0.0,
        (Beyond::Periodic, _) => between(count - 1, 0),
        (Beyond::Linear, 1) => secants[k],
        (Beyond::Linear, _) => {
            let (h, other) = (widths[k], widths[next]);
            let slope = ((2.0 * h + other) * secants[k] - h * secants[next]) / (h + other);
            if slope * secants[k] <= 0.0 {
                0.0
            } else if secants[k] * secants[next] <= 0.0 && slope.abs() > 3.0 * secants[k].abs() {
                3.0 * secants[k]
            } else {
                slope
            }
        }
    };
    let inner = (1..count).map(|k| between(k - 1, k));
    let first = end(0, 1.min(count - 1));
    let last = end(count - 1, count.saturating_sub(2));
    [first].into_iter().chain(inner).chain([last]).collect()
}

impl Graph {
    /// A table's function of x, one of its derivatives, or its integral.
    pub fn table(&mut self, table: &Arc<Table>, order: i8, x: Expr) -> Expr {
        if order > table.degree() {
            return self.zero();
        }
        match self.as_constant(x) {
            Some(x) if table.data.is_none() => self.constant(table.value(x, order)),
            _ => self.intern(Node::Table {
                table: table.clone(),
                order,
                x,
            }),
        }
    }
}
