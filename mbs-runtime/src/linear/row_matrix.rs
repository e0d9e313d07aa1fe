//! A matrix that is worked on row by row.

use crate::MatrixSink;
use crate::memory::OnDemand;
use core::ops::{Deref, DerefMut, Index, IndexMut};
use nalgebra::{SMatrix, SVector};

/// R rows of N entries, kept by [`memory`](crate::memory): large systems are built on small stacks.
///
/// The contract passes rows as the columns of `SMatrix<f64, N, R>`, so that a row is contiguous; `matrix[i]` is row i, and
/// as a [`MatrixSink`] it takes entry (row, column).
#[derive(Debug, Clone)]
pub(crate) struct RowMatrix<const N: usize, const R: usize>(OnDemand<SMatrix<f64, N, R>>);

impl<const N: usize, const R: usize> RowMatrix<N, R> {
    /// Rows of zeros, which never were on the stack.
    pub(crate) fn zeros() -> Self {
        RowMatrix(OnDemand::zeros())
    }

    /// Copies all entries of another matrix, of which an assignment could make a copy on the stack first.
    #[inline(always)]
    pub(crate) fn overwrite(&mut self, other: &Self) {
        self.0.data.0.copy_from_slice(&other.0.data.0);
    }

    /// All entries, `[row][column]`: a [`MatrixSink`] without the way through the heap pointer.
    #[inline(always)]
    pub(crate) fn entries_mut(&mut self) -> &mut [[f64; N]; R] {
        &mut self.0.data.0
    }

    /// All rows.
    #[inline(always)]
    pub(crate) fn rows(&self) -> &[SVector<f64, N>; R] {
        rows(&self.0)
    }

    /// All rows, to be written.
    #[inline(always)]
    pub(crate) fn rows_mut(&mut self) -> &mut [SVector<f64, N>; R] {
        bytemuck::cast_mut(&mut *self.0)
    }
}

/// The rows of a matrix that holds them as columns.
#[inline(always)]
pub(crate) fn rows<const N: usize, const R: usize>(
    matrix: &SMatrix<f64, N, R>,
) -> &[SVector<f64, N>; R] {
    bytemuck::cast_ref(matrix)
}

impl<const N: usize, const R: usize> Deref for RowMatrix<N, R> {
    type Target = SMatrix<f64, N, R>;
    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl<const N: usize, const R: usize> DerefMut for RowMatrix<N, R> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}

impl<const N: usize, const R: usize> Index<usize> for RowMatrix<N, R> {
    type Output = SVector<f64, N>;
    #[inline(always)]
    fn index(&self, row: usize) -> &SVector<f64, N> {
        &self.rows()[row]
    }
}

impl<const N: usize, const R: usize> IndexMut<usize> for RowMatrix<N, R> {
    #[inline(always)]
    fn index_mut(&mut self, row: usize) -> &mut SVector<f64, N> {
        &mut self.rows_mut()[row]
    }
}

impl<const N: usize, const R: usize> MatrixSink for RowMatrix<N, R> {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.0.data.0[row][column] = value;
    }
}
