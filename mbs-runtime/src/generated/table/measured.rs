//! Tables whose points are parameters: the pieces are computed once for a set of parameters.

use super::{Table, integral};
use crate::ParameterError;

/// Between the points of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Monotone cubic polynomials.
    Cubic,
    /// Straight lines.
    Linear,
}

/// Outside the points of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beyond {
    /// The slope at the end goes on.
    Linear,
    /// The value at the end goes on.
    Constant,
    /// The curve is repeated.
    Periodic,
}

/// The knots and the pieces of a table of one mechanism; PIECES is KNOTS + 1.
#[derive(Debug, Clone, Copy)]
pub struct MeasuredTable<const KNOTS: usize, const PIECES: usize> {
    knots: [f64; KNOTS],
    pieces: [[f64; 5]; PIECES],
}

impl<const KNOTS: usize, const PIECES: usize> MeasuredTable<KNOTS, PIECES> {
    /// Through the points (x, y), of which there are at least two; with the operations by which the compiler computes the
    /// pieces of a table of numbers.
    ///
    /// # Errors
    /// [`ParameterError::TableNotIncreasing`], [`ParameterError::TableNotPeriodic`] and [`ParameterError::TableNotFinite`].
    pub fn through(
        table: &'static str,
        x: [f64; KNOTS],
        y: [f64; KNOTS],
        interpolation: Interpolation,
        beyond: Beyond,
    ) -> Result<Self, ParameterError> {
        const { assert!(KNOTS >= 2 && PIECES == KNOTS + 1) };
        if let Some(at) = (1..KNOTS).find(|&k| x[k] <= x[k - 1]) {
            return Err(ParameterError::TableNotIncreasing {
                table,
                index: at,
                argument: x[at],
                before: x[at - 1],
            });
        }
        let last = KNOTS - 1;
        if beyond == Beyond::Periodic && y[0] != y[last] {
            return Err(ParameterError::TableNotPeriodic {
                table,
                ends: [y[0], y[last]],
            });
        }
        // Of each interval; the last entry is unused.
        let widths: [f64; KNOTS] = core::array::from_fn(|k| x[(k + 1).min(last)] - x[k]);
        let secants: [f64; KNOTS] =
            core::array::from_fn(|k| (y[(k + 1).min(last)] - y[k]) / widths[k]);
        let slopes = monotone_slopes(&widths, &secants, beyond);
        let mut pieces = [[0.0; 5]; PIECES];
        for k in 0..last {
            let (h, secant) = (widths[k], secants[k]);
            let [left, right] = [slopes[k], slopes[k + 1]];
            pieces[k + 1] = match interpolation {
                Interpolation::Linear => [y[k], secant, 0.0, 0.0, 0.0],
                Interpolation::Cubic => {
                    let square = (3.0 * secant - 2.0 * left - right) / h;
                    let cube = (left + right - 2.0 * secant) / (h * h);
                    [y[k], left, square, cube, 0.0]
                }
            };
        }
        let ends = match (beyond, interpolation) {
            (Beyond::Constant, _) => [0.0; 2],
            (Beyond::Linear, Interpolation::Linear) => [secants[0], secants[last - 1]],
            (Beyond::Periodic, Interpolation::Linear) => [secants[last - 1], secants[0]],
            (_, Interpolation::Cubic) => [slopes[0], slopes[last]],
        };
        pieces[0] = [y[0], ends[0], 0.0, 0.0, 0.0];
        pieces[KNOTS] = [y[last], ends[1], 0.0, 0.0, 0.0];
        // Integrals from the first knot, and then from 0.
        for k in 0..last {
            pieces[k + 2][4] = integral(&pieces[k + 1], widths[k]);
        }
        let mut measured = MeasuredTable { knots: x, pieces };
        let table_of_zero = measured.as_table();
        let zero = match beyond {
            Beyond::Periodic => table_of_zero.periodic().integral(0.0),
            _ => table_of_zero.integral(0.0),
        };
        measured
            .pieces
            .iter_mut()
            .for_each(|piece| piece[4] -= zero);
        match measured.pieces.as_flattened().iter().all(|x| x.is_finite()) {
            true => Ok(measured),
            false => Err(ParameterError::TableNotFinite { table }),
        }
    }

    /// The function.
    #[inline]
    pub fn as_table(&self) -> Table<'_> {
        Table {
            knots: &self.knots,
            pieces: &self.pieces,
        }
    }
}

/// Slopes at the knots with which cubic polynomials are monotone where the values are (Fritsch and Butland 1984).
fn monotone_slopes<const KNOTS: usize>(
    widths: &[f64; KNOTS],
    secants: &[f64; KNOTS],
    beyond: Beyond,
) -> [f64; KNOTS] {
    let count = KNOTS - 1;
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
    core::array::from_fn(|k| match k {
        0 => end(0, 1.min(count - 1)),
        k if k == count => end(count - 1, count.saturating_sub(2)),
        k => between(k - 1, k),
    })
}
