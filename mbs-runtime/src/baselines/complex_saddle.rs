//! The linear equations of [`Saddle`] with a complex J = B + iC, as collocation has them:
//!
//! ```text
//! J x − Aᵀ μ = r,    A x = g
//! ```
//!
//! They are factored as one matrix with pivots from all rows, without the rows and multipliers that the real one has left out.
//! Unknowns and equations are scaled to unit length first: lengths and angles have different units.

use super::saddle::Saddle;
use crate::linear::RowMatrix;
use nalgebra::Complex;

type Number = Complex<f64>;

/// The matrix and its factors, allocated once.
#[derive(Clone)]
pub(crate) struct ComplexSaddle<const N: usize, const R: usize> {
    /// (N + R)² entries, row by row, of which the first `size` rows and columns are in use.
    lu: Box<[Number]>,
    exchanges: Box<[usize]>,
    scale: Box<[f64]>,
    /// Equations and multipliers: the rows that are kept.
    kept: [[usize; R]; 2],
    size: usize,
    x: Box<[Number]>,
}

impl<const N: usize, const R: usize> ComplexSaddle<N, R> {
    pub(crate) fn new() -> Self {
        let zero = Number::new(0.0, 0.0);
        ComplexSaddle {
            lu: vec![zero; (N + R) * (N + R)].into(),
            exchanges: vec![0; N + R].into(),
            scale: vec![0.0; N + R].into(),
            kept: [[0; R]; 2],
            size: 0,
            x: vec![zero; N + R].into(),
        }
    }

    /// Factors the equations with J = `entry`(i, j), with the rows that the real matrix has kept; false if they are singular or
    /// not finite.
    pub(crate) fn factor(
        &mut self,
        entry: impl Fn(usize, usize) -> Number,
        a: &RowMatrix<N, R>,
        real: &Saddle<N, R>,
    ) -> bool {
        let (rank, [rows, multipliers]) = real.kept();
        self.kept = [rows, multipliers];
        self.size = N + rank;
        let size = self.size;
        for i in 0..N {
            let diagonal = entry(i, i).norm();
            self.scale[i] = if diagonal > 0.0 {
                1.0 / diagonal.sqrt()
            } else {
                1.0
            };
        }
        let scale = &self.scale;
        for i in 0..N {
            for j in 0..N {
                self.lu[i * size + j] = entry(i, j) * (scale[i] * scale[j]);
            }
            for k in 0..rank {
                let (row, multiplier) = (rows[k], multipliers[k]);
                let below = real.row_scale(row) * a[row][i] * scale[i];
                let beside = -real.row_scale(multiplier) * a[multiplier][i] * scale[i];
                self.lu[(N + k) * size + i] = Number::new(below, 0.0);
                self.lu[i * size + N + k] = Number::new(beside, 0.0);
            }
        }
        for k in 0..rank {
            self.lu[(N + k) * size + N..][..rank].fill(Number::new(0.0, 0.0));
        }
        self.eliminate()
    }

    fn eliminate(&mut self) -> bool {
        let size = self.size;
        for k in 0..size {
            let length = |i: usize| self.lu[i * size + k].norm_sqr();
            let pivot = (k + 1..size).fold(k, |best, i| match length(i) > length(best) {
                true => i,
                false => best,
            });
            self.exchanges[k] = pivot;
            if pivot != k {
                for j in 0..size {
                    self.lu.swap(k * size + j, pivot * size + j);
                }
            }
            let (above, below) = self.lu.split_at_mut((k + 1) * size);
            let pivots = &above[k * size..];
            if !(pivots[k].norm_sqr() > f64::MIN_POSITIVE && pivots[k].norm_sqr().is_finite()) {
                return false;
            }
            let inverse = pivots[k].inv();
            for row in below[..(size - k - 1) * size].chunks_exact_mut(size) {
                let factor = row[k] * inverse;
                row[k] = factor;
                for (entry, pivot) in row.iter_mut().zip(pivots).skip(k + 1) {
                    *entry -= factor * pivot;
                }
            }
        }
        true
    }

    /// r and g become x and μ; multipliers of rows that were left out are zero.
    pub(crate) fn solve(
        &mut self,
        x: &mut [Number; N],
        rows: &mut [Number; R],
        real: &Saddle<N, R>,
    ) {
        let (size, rank) = (self.size, self.size - N);
        let [kept, multipliers] = self.kept;
        for i in 0..N {
            self.x[i] = x[i] * self.scale[i];
        }
        for k in 0..rank {
            self.x[N + k] = rows[kept[k]] * real.row_scale(kept[k]);
        }
        let y = &mut self.x[..size];
        for k in 0..size {
            y.swap(k, self.exchanges[k]);
        }
        for i in 0..size {
            let line = &self.lu[i * size..][..size];
            let known: Number = line[..i].iter().zip(&*y).map(|(a, y)| a * y).sum();
            y[i] -= known;
        }
        for i in (0..size).rev() {
            let line = &self.lu[i * size..][..size];
            let known: Number = line[i + 1..]
                .iter()
                .zip(&y[i + 1..])
                .map(|(a, y)| a * y)
                .sum();
            y[i] = (y[i] - known) / line[i];
        }
        for i in 0..N {
            x[i] = self.x[i] * self.scale[i];
        }
        rows.fill(Number::new(0.0, 0.0));
        for k in 0..rank {
            rows[multipliers[k]] = self.x[N + k] * real.row_scale(multipliers[k]);
        }
    }
}
