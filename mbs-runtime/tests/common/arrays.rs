//! Sums over arrays, and differences.

use mbs_runtime::MatrixSink;
use mbs_runtime::generated::entries;
use mbs_runtime::nalgebra::{SMatrix, SVector};

/// The largest difference of two entries.
pub fn distance<'a>(
    a: impl IntoIterator<Item = &'a f64>,
    b: impl IntoIterator<Item = &'a f64>,
) -> f64 {
    let pairs = a.into_iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

pub fn unit<const N: usize>(j: usize) -> SVector<f64, N> {
    SVector::from_fn(|i, _| if i == j { 1.0 } else { 0.0 })
}

/// From its rows.
pub fn matrix<const N: usize, const R: usize>(rows: [[f64; N]; R]) -> SMatrix<f64, R, N> {
    SMatrix::<f64, N, R>::from(rows).transpose()
}

pub(super) fn part<const K: usize>(x: &[f64], i: usize) -> [f64; K] {
    let mut part = [0.0; K];
    part.copy_from_slice(&x[i..i + K]);
    part
}

pub(super) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let (mut sum, mut i) = (0.0, 0);
    while i < N {
        sum += a[i] * b[i];
        i += 1;
    }
    sum
}

/// The product with a symmetric matrix.
pub(super) fn solved<const N: usize>(inverse: &SMatrix<f64, N, N>, x: &[f64; N]) -> [f64; N] {
    let columns = &inverse.data.0;
    let mut product = [0.0; N];
    let mut j = 0;
    while j < N {
        if x[j] != 0.0 {
            let mut i = 0;
            while i < N {
                product[i] += columns[j][i] * x[j];
                i += 1;
            }
        }
        j += 1;
    }
    product
}

pub(super) fn put<const N: usize, const R: usize>(
    rows: &[[f64; N]; R],
    sink: &mut impl MatrixSink,
) {
    let mut i = 0;
    while i < R {
        let mut j = 0;
        while j < N {
            sink.set(i, j, rows[i][j]);
            j += 1;
        }
        i += 1;
    }
}

/// Column by column ∂f/∂x by central differences, into a sink; zero unless f `varies`.
pub(super) fn differences<const N: usize>(
    varies: bool,
    x: &SVector<f64, N>,
    sink: &mut impl MatrixSink,
    f: impl Fn(&SVector<f64, N>) -> [f64; N],
) {
    if !varies {
        return put(&[[0.0; N]; N], sink);
    }
    let e = 1e-6;
    let at = |j: usize, e: f64| {
        let mut x = *entries(x);
        x[j] += e;
        f(&x.into())
    };
    let mut j = 0;
    while j < N {
        let (up, down) = (at(j, e), at(j, -e));
        let mut i = 0;
        while i < N {
            sink.set(i, j, (up[i] - down[i]) / (2.0 * e));
            i += 1;
        }
        j += 1;
    }
}
