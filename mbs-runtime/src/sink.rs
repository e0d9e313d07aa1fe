//! Where generated code writes matrices.
//!
//! The same generated code writes dense arrays and sparse storage: it writes each structurally nonzero entry once, in a
//! fixed order, and never a structural zero. The owner of the storage clears it once, when it is made.

use crate::memory::Box;
use nalgebra::SMatrix;

/// Receives the structurally nonzero entries of a matrix, each exactly once per evaluation and always in the same order.
pub trait MatrixSink {
    /// Stores entry (`row`, `column`).
    fn set(&mut self, row: usize, column: usize, value: f64);
}

impl<const ROWS: usize, const COLUMNS: usize> MatrixSink for SMatrix<f64, ROWS, COLUMNS> {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.data.0[column][row] = value;
    }
}

impl<const ROWS: usize, const COLUMNS: usize> MatrixSink for [[f64; COLUMNS]; ROWS] {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self[row][column] = value;
    }
}

impl<M: MatrixSink + ?Sized> MatrixSink for Box<M> {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        (**self).set(row, column, value);
    }
}

/// Receives the nonzero affinities Γ with three indices, once each per evaluation.
pub trait TensorSink {
    /// Stores entry (`i`, `j`, `k`).
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64);
}

/// Entry (`j`, `k`) of matrix `i`.
impl<const N: usize> TensorSink for [SMatrix<f64, N, N>; N] {
    #[inline(always)]
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        self[i][(j, k)] = value;
    }
}

impl<const N: usize> TensorSink for [[[f64; N]; N]; N] {
    #[inline(always)]
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        self[i][j][k] = value;
    }
}

/// A sink that ignores the matrix.
#[derive(Debug)]
pub struct Discard;

impl MatrixSink for Discard {
    #[inline(always)]
    fn set(&mut self, _: usize, _: usize, _: f64) {}
}

/// A sink that keeps the diagonal.
pub(crate) struct Diagonal<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Diagonal<N> {
    pub(crate) fn zeros() -> Self {
        Diagonal([0.0; N])
    }
}

impl<const N: usize> MatrixSink for Diagonal<N> {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        if row == column {
            self.0[row] = value;
        }
    }
}
