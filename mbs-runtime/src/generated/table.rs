//! Functions given by measured values.

pub use measured::{Beyond, Interpolation, MeasuredTable};
pub use periodic::PeriodicTable;

mod measured;
mod periodic;

/// A polynomial of third degree before the first knot, in each interval, and after the last knot.
#[derive(Debug, Clone, Copy)]
pub struct Table<'a> {
    /// Where one piece ends and the next begins, increasing.
    pub knots: &'a [f64],
    /// One more than knots: the coefficients of powers 0 to 3 of x minus the knot on the left (of the first piece: minus
    /// the first knot), and the integral from 0 to there.
    pub pieces: &'a [[f64; 5]],
}

impl<'a> Table<'a> {
    /// The curve between the first and the last knot, repeated.
    #[inline]
    pub fn periodic(&self) -> PeriodicTable<'a> {
        PeriodicTable::of(*self)
    }

    /// The piece at x, and how far x is inside it.
    #[inline]
    fn piece(&self, x: f64) -> (&'a [f64; 5], f64) {
        let after = self.knots.partition_point(|&knot| knot <= x);
        (&self.pieces[after], x - self.knots[after.saturating_sub(1)])
    }

    /// The integral from 0.
    pub fn integral(&self, x: f64) -> f64 {
        let (piece, h) = self.piece(x);
        integral(piece, h)
    }

    /// The function.
    pub fn value(&self, x: f64) -> f64 {
        let (&[a, b, c, d, _], h) = self.piece(x);
        a + h * (b + h * (c + h * d))
    }

    /// Its first derivative.
    pub fn slope(&self, x: f64) -> f64 {
        let (&[_, b, c, d, _], h) = self.piece(x);
        b + h * (2.0 * c + h * (3.0 * d))
    }

    /// Its second derivative.
    pub fn second(&self, x: f64) -> f64 {
        let (&[_, _, c, d, _], h) = self.piece(x);
        2.0 * c + h * (6.0 * d)
    }

    /// Its third derivative.
    pub fn third(&self, x: f64) -> f64 {
        let (&[_, _, _, d, _], _) = self.piece(x);
        6.0 * d
    }
}

/// The integral at h inside a piece.
fn integral(&[a, b, c, d, integral]: &[f64; 5], h: f64) -> f64 {
    integral + h * (a + h * (b / 2.0 + h * (c / 3.0 + h * (d / 4.0))))
}
