//! The factor of a mass matrix, and the inverse of one that is constant.

use crate::ParameterError;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::linear::lanes::{Lane, Substitution, scale, solve_rows, subtract};
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

/// M = LᵀL, with the inverse diagonal kept. In this order the factor of a tree of bodies has no other entries than M where the
/// coordinates of a body come after those of the bodies that carry it (Featherstone, Rigid Body Dynamics Algorithms, 2008,
/// section 6.5).
#[derive(Debug, Clone)]
pub struct Cholesky<const N: usize> {
    /// Its rows; nothing is read above the diagonal.
    lower: [[f64; N]; N],
    inverse_diagonal: [f64; N],
}

impl<const N: usize> Cholesky<N> {
    /// The factor of M, of which the upper triangle is read; `None` if M is not positive definite (to 1/[`WEAKEST`] of its
    /// diagonal).
    #[inline]
    pub fn new(mass: &SMatrix<f64, N, N>) -> Option<Self> {
        // M is symmetric: its columns are its rows.
        let mut lower = mass.data.0;
        let mut inverse_diagonal = [0.0; N];
        factor_in_place(&mut lower, &mut inverse_diagonal, 0..N).ok()?;
        Some(Cholesky {
            lower,
            inverse_diagonal,
        })
    }

    /// x ← M⁻¹ x.
    #[inline]
    pub fn solve(&self, x: &mut SVector<f64, N>) {
        let [x] = &mut x.data.0;
        self.one(x);
    }

    /// W = M⁻¹Aᵀ from the rows of A.
    #[inline]
    pub fn solve_rows<const R: usize>(&self, a: &SMatrix<f64, N, R>, w: &mut SMatrix<f64, N, R>) {
        w.data.0 = a.data.0;
        solve_rows(self, &mut w.data.0);
    }
}

impl<const N: usize> Substitution<N> for Cholesky<N> {
    fn one(&self, x: &mut [f64; N]) {
        solve(&self.lower, &self.inverse_diagonal, x, 0..N);
    }

    fn several<const WIDTH: usize>(&self, x: &mut [Lane<WIDTH>; N]) {
        for i in (0..N).rev() {
            // Rows of A that do not move a body, nor what it carries, have zeros here.
            if x[i] == [0.0; WIDTH] {
                continue;
            }
            let mut value = x[i];
            scale(&mut value, self.inverse_diagonal[i]);
            x[i] = value;
            for (rest, &entry) in x[..i].iter_mut().zip(&self.lower[i][..i]) {
                subtract(rest, entry, &value);
            }
        }
        for i in 0..N {
            let mut value = x[i];
            for (&entry, known) in self.lower[i][..i].iter().zip(&x[..i]) {
                subtract(&mut value, entry, known);
            }
            scale(&mut value, self.inverse_diagonal[i]);
            x[i] = value;
        }
    }
}

/// L of M = LᵀL in place of a diagonal block of M; `inverse_diagonal` is that of L. Each row is subtracted from those above
/// it as soon as it is known: entries of a row do not wait for each other, as they would in a sum of products.
#[inline(always)]
fn factor_in_place<const N: usize>(
    lower: &mut [[f64; N]; N],
    inverse_diagonal: &mut [f64; N],
    block: Range<usize>,
) -> Result<(), usize> {
    let Range { start, end } = block;
    // The pivots are what is left of the diagonal of M.
    let mut whole = [0.0; N];
    for k in start..end {
        whole[k] = lower[k][k];
    }
    for k in (start..end).rev() {
        let (above, known) = lower.split_at_mut(k);
        let row = &mut known[0][start..=k];
        let pivot = row[k - start];
        if !is_positive(pivot, whole[k]) {
            return Err(k);
        }
        let inverse = 1.0 / pivot.sqrt();
        inverse_diagonal[k] = inverse;
        let row = &mut row[..k - start];
        row.iter_mut().for_each(|entry| *entry *= inverse);
        for (i, other) in above[start..].iter_mut().enumerate() {
            let factor = row[i];
            if factor == 0.0 {
                continue;
            }
            for (entry, &l) in other[start..=start + i].iter_mut().zip(&row[..=i]) {
                *entry -= factor * l;
            }
        }
    }
    Ok(())
}

/// x ← M⁻¹ x in a diagonal block of M.
#[inline(always)]
fn solve<const N: usize>(
    lower: &[[f64; N]; N],
    inverse_diagonal: &[f64; N],
    x: &mut [f64; N],
    block: Range<usize>,
) {
    let Range { start, end } = block;
    for i in (start..end).rev() {
        let value = x[i] * inverse_diagonal[i];
        x[i] = value;
        for (entry, &l) in x[start..i].iter_mut().zip(&lower[i][start..i]) {
            *entry -= value * l;
        }
    }
    for i in start..end {
        let products = lower[i][start..i].iter().zip(&x[start..i]);
        let value = products.fold(x[i], |value, (l, x)| value - l * x);
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
    let lower = &mut mass.data.0;
    let mut inverse_diagonal = [0.0; N];
    let mut inverse = clear_mass();
    let mut start = 0;
    while start < N {
        let block = start..end_of_block(lower, start);
        factor_in_place(lower, &mut inverse_diagonal, block.clone()).map_err(|column| {
            ParameterError::MassNotPositive {
                coordinate: coordinates[column],
            }
        })?;
        for i in block.clone() {
            let column = &mut inverse.data.0[i];
            column[i] = 1.0;
            solve(lower, &inverse_diagonal, column, block.clone());
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
