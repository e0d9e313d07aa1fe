//! Functions for generated code. They are public because generated code is in users' crates; do not call them by
//! hand.

use crate::ParameterError;
pub use crate::affinities::by_tangents as affinities;
use crate::linear::{added, vector};
use nalgebra::{SMatrix, SVector};

pub use crate::contract::{Elimination, Kicks, Rates};
pub use crate::elementary::Elementary;
pub use crate::linear::{entries, entries_mut};
pub use crate::memory::Box;
pub use crate::scalar_state::with_scales;
pub use crate::singular::DEPENDENT;
pub use crate::sink::Discard;
pub use checks::{require_inertia, require_not_negative, require_positive};
pub use cholesky::{Cholesky, clear_mass, inverse_mass, positive};
pub use constant_mass::{
    ConstantMass, FactoredMass, LongMass, factored_mass, multiply, multiply_rows,
};
pub use parts::{compute_parts, rows_of};
pub use rotation::{rotation_between, turned};
pub use spin::Spin;
pub use table::{Beyond, Interpolation, MeasuredTable, PeriodicTable, Table};
pub use unfinished::{SIZE as UNFINISHED_SIZE, UNFINISHED, Unfinished};
pub use values::Values;

mod checks;
mod cholesky;
mod constant_mass;
mod parts;
pub mod pattern;
mod principal;
mod rotation;
mod spin;
mod table;
mod unfinished;
mod values;

/// A pivot below this fraction of its diagonal entry is round-off.
const ROUND_OFF: f64 = 1e-12;

/// 1/d of a pivot d whose diagonal entry was `whole`; 0 if d is round-off relative to it: then its row depends
/// on those before it.
#[inline(always)]
pub fn pivot_inverse(pivot: f64, whole: f64) -> f64 {
    if pivot > ROUND_OFF * whole {
        1.0 / pivot
    } else {
        0.0
    }
}

/// The larger of two numbers; not a number where one of them is not.
#[inline]
pub fn larger(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// −1, 0 or 1.
#[inline]
pub fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// 1 where `x` is positive, else 0.
#[inline]
pub fn step(x: f64) -> f64 {
    if x > 0.0 { 1.0 } else { 0.0 }
}

/// x ≥ 0, or a tiny number where it vanishes; not a number where x is not. The slope of a root or power is divided by it: the dividend
/// vanishes there as well.
///
/// The n-th derivative of a root divides by its (2n − 1)-th power. 1e-40 to the seventh is a normal number: derivatives up to the
/// fourth are finite.
#[inline]
pub fn nonzero(x: f64) -> f64 {
    if x < 1e-40 { 1e-40 } else { x }
}

/// Refuses a parameter that is not finite.
///
/// # Errors
/// [`ParameterError::NotFinite`].
pub fn check_finite(name: &'static str, value: f64) -> Result<(), ParameterError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(ParameterError::NotFinite { name, value })
    }
}

/// q + h v: [`advance`](crate::Configuration::advance) where no coordinate is a rotation.
#[inline]
pub fn translated<const N: usize>(
    q: &SVector<f64, N>,
    v: &SVector<f64, N>,
    h: f64,
) -> SVector<f64, N> {
    added(q, h, v)
}

/// to − from: [`difference`](crate::Configuration::difference) where no coordinate is a rotation.
#[inline]
pub fn displacement<const N: usize>(
    from: &SVector<f64, N>,
    to: &SVector<f64, N>,
) -> SVector<f64, N> {
    let (from, to) = (entries(from), entries(to));
    vector(|i| to[i] - from[i])
}

/// The rows of A W from those of A and the columns of W, skipping the zeros of A.
pub fn delassus<const N: usize, const R: usize>(
    a: &SMatrix<f64, N, R>,
    w: &SMatrix<f64, N, R>,
    delassus: &mut SMatrix<f64, R, R>,
) {
    for (row, a) in delassus.data.0.iter_mut().zip(&a.data.0) {
        *row = [0.0; R];
        for (column, &entry) in a.iter().enumerate() {
            if entry != 0.0 {
                for (value, w) in row.iter_mut().zip(&w.data.0) {
                    *value += entry * w[column];
                }
            }
        }
    }
}

/// W = M⁻¹Aᵀ row by row, where `solve` is x ← M⁻¹x.
pub fn solve_rows<const N: usize, const R: usize>(
    a: &SMatrix<f64, N, R>,
    w: &mut SMatrix<f64, N, R>,
    solve: impl Fn(&mut SVector<f64, N>),
) {
    for (w, a) in w.column_iter_mut().zip(a.column_iter()) {
        let mut row = a.into_owned();
        solve(&mut row);
        { w }.copy_from(&row);
    }
}

/// The rows of a matrix that holds them as columns.
#[inline(always)]
pub fn rows<const N: usize, const R: usize>(matrix: &SMatrix<f64, N, R>) -> &[[f64; N]; R] {
    &matrix.data.0
}

/// The rows of a matrix that holds them as columns, to be written.
#[inline(always)]
pub fn rows_mut<const N: usize, const R: usize>(
    matrix: &mut SMatrix<f64, N, R>,
) -> &mut [[f64; N]; R] {
    &mut matrix.data.0
}
