//! Tables that are repeated.

use super::Table;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;

/// The curve of a table between its first and its last knot, again and again.
#[derive(Debug, Clone, Copy)]
pub struct PeriodicTable<'a>(Table<'a>);

impl<'a> PeriodicTable<'a> {
    #[inline]
    pub(super) fn of(table: Table<'a>) -> Self {
        Self(table)
    }

    /// How many periods x lies behind the first one, and where x is in the first one.
    #[inline]
    fn place(&self, x: f64) -> (f64, f64) {
        let knots = self.0.knots;
        let (first, last) = (knots[0], knots[knots.len() - 1]);
        if (first..last).contains(&x) {
            return (0.0, x);
        }
        let period = last - first;
        let periods = ((x - first) / period).floor();
        (periods, x - periods * period)
    }

    /// The integral from 0.
    pub fn integral(&self, x: f64) -> f64 {
        let (periods, x) = self.place(x);
        let pieces = self.0.pieces;
        self.0.integral(x) + periods * (pieces[pieces.len() - 1][4] - pieces[1][4])
    }

    /// The function.
    pub fn value(&self, x: f64) -> f64 {
        self.0.value(self.place(x).1)
    }

    /// Its first derivative.
    pub fn slope(&self, x: f64) -> f64 {
        self.0.slope(self.place(x).1)
    }

    /// Its second derivative.
    pub fn second(&self, x: f64) -> f64 {
        self.0.second(self.place(x).1)
    }

    /// Its third derivative.
    pub fn third(&self, x: f64) -> f64 {
        self.0.third(self.place(x).1)
    }
}
