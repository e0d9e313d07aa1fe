//! The factor of a mass matrix, and the inverse of one that is constant.

use crate::ParameterError;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::memory::{Box, zeroed};
use core::ops::Range;
use nalgebra::{SMatrix, SVector};

/// How much larger than its pivot a diagonal entry of M may be: beyond that the pivot is round-off.
const WEAKEST: f64 = 1e14;

/// Whether the pivots of M = L D Lᵀ are positive: D⁻¹ leads the factor, `pivot_loss` is diag(M) D⁻¹.
#[inline]
pub fn positive<const N: usize>(factor: &[f64], pivot_loss: &[f64; N]) -> bool {
    let inverses = factor.iter().zip(pivot_loss);
    // Written so that NaN is refused, too.
    inverses.fold(true, |all, (&inverse, &pivot_loss)| {
        all & (inverse > 0.0) & (pivot_loss < WEAKEST)
    })
}

/// Whether a pivot of M is more than the round-off of its diagonal entry. Written so that NaN is refused, too.
#[inline(always)]
pub(super) fn is_positive(pivot: f64, whole: f64) -> bool {
    pivot * WEAKEST > whole && pivot.is_finite()
}

/// M = Uᵀ U, with the inverse diagonal kept.
#[derive(Debug, Clone)]
pub struct Cholesky<const N: usize> {
    /// Its rows; nothing is read below the diagonal.
    upper: [[f64; N]; N],
    inverse_diagonal: [f64; N],
}

impl<const N: usize> Cholesky<N> {
    /// The factor of M; `None` if M is not positive definite.
    #[inline]
    pub fn new(mass: &SMatrix<f64, N, N>) -> Option<Self> {
        Self::factor(mass).ok()
    }

    /// The factor of M, of which the lower triangle is read.
    ///
    /// # Errors
    /// The column at which M stops being positive definite (to 1/[`WEAKEST`] of its diagonal).
    #[inline]
    pub fn factor(mass: &SMatrix<f64, N, N>) -> Result<Self, usize> {
        // M is symmetric: its columns are its rows.
        let mut upper = mass.data.0;
        let mut inverse_diagonal = [0.0; N];
        factor_in_place(&mut upper, &mut inverse_diagonal, 0..N)?;
        Ok(Cholesky {
            upper,
            inverse_diagonal,
        })
    }

    /// x ← M⁻¹ x.
    #[inline]
    pub fn solve(&self, x: &mut SVector<f64, N>) {
        let [x] = &mut x.data.0;
        solve(&self.upper, &self.inverse_diagonal, x, 0..N);
    }
}

/// U of M = Uᵀ U in place of a diagonal block of M; `inverse_diagonal` is that of U. Each row is subtracted from those below
/// it as soon as it is known: entries of a row do not wait for each other, as they would in a sum of products.
#[inline(always)]
fn factor_in_place<const N: usize>(
    upper: &mut [[f64; N]; N],
    inverse_diagonal: &mut [f64; N],
    block: Range<usize>,
) -> Result<(), usize> {
    let Range { start, end } = block;
    // The pivots are what is left of the diagonal of M.
    let mut whole = [0.0; N];
    for k in start..end {
        whole[k] = upper[k][k];
    }
    for k in start..end {
        let (known, below) = upper.split_at_mut(k + 1);
        let row = &mut known[k][..end];
        let pivot = row[k];
        if !is_positive(pivot, whole[k]) {
            return Err(k);
        }
        let inverse = 1.0 / pivot.sqrt();
        inverse_diagonal[k] = inverse;
        row[k + 1..].iter_mut().for_each(|entry| *entry *= inverse);
        for (i, other) in (k + 1..end).zip(below) {
            let factor = row[i];
            for (entry, &u) in other[i..end].iter_mut().zip(&row[i..]) {
                *entry -= factor * u;
            }
        }
    }
    Ok(())
}

/// x ← M⁻¹ x in a diagonal block of M.
#[inline(always)]
fn solve<const N: usize>(
    upper: &[[f64; N]; N],
    inverse_diagonal: &[f64; N],
    x: &mut [f64; N],
    block: Range<usize>,
) {
    let Range { start, end } = block;
    for i in start..end {
        let value = x[i] * inverse_diagonal[i];
        x[i] = value;
        for (entry, &u) in x[i + 1..end].iter_mut().zip(&upper[i][i + 1..end]) {
            *entry -= value * u;
        }
    }
    for i in (start..end).rev() {
        let products = upper[i][i + 1..end].iter().zip(&x[i + 1..end]);
        let value = products.fold(x[i], |value, (u, x)| value - u * x);
        x[i] = value * inverse_diagonal[i];
    }
}

/// Where the diagonal block of a symmetric matrix that begins at `start` ends: the bodies of a mechanism have blocks of
/// their own.
fn end_of_block<const N: usize>(matrix: &[[f64; N]; N], start: usize) -> usize {
    let mut end = start + 1;
    let mut row = start;
    while row < end {
        let beyond = matrix[row][end..].iter().rposition(|&entry| entry != 0.0);
        end += beyond.map_or(0, |last| last + 1);
        row += 1;
    }
    end
}

/// M⁻¹ of a constant mass matrix, in whose place its factor is left; on the heap, because a large one does not fit on the
/// stack.
///
/// # Errors
/// [`ParameterError::MassNotPositive`] at the coordinate where M stops being positive definite.
#[inline(never)]
pub fn inverse_mass<const N: usize>(
    mass: &mut SMatrix<f64, N, N>,
    coordinates: &[&'static str; N],
) -> Result<Box<SMatrix<f64, N, N>>, ParameterError> {
    let upper = &mut mass.data.0;
    let mut inverse_diagonal = [0.0; N];
    let mut inverse = clear_mass();
    let mut start = 0;
    while start < N {
        let block = start..end_of_block(upper, start);
        factor_in_place(upper, &mut inverse_diagonal, block.clone()).map_err(|column| {
            ParameterError::MassNotPositive {
                coordinate: coordinates[column],
            }
        })?;
        for i in block.clone() {
            let column = &mut inverse.data.0[i];
            column[i] = 1.0;
            solve(upper, &inverse_diagonal, column, block.clone());
        }
        start = block.end;
    }
    // Exactly symmetric: generated code reads one triangle.
    inverse.fill_upper_triangle_with_lower_triangle();
    Ok(inverse)
}

/// A matrix of zeros, which never was on the stack.
pub fn clear_mass<const N: usize>() -> Box<SMatrix<f64, N, N>> {
    zeroed()
}
