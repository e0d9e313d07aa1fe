//! A long mass matrix without its zeros: that of a chain has a few entries in each row, while its inverse is full.

use super::ConstantMass;
use crate::ParameterError;
use crate::generated::cholesky::is_positive;
use crate::linear::entries_mut;
use crate::linear::sparse::{Ldl, SparseRows};
use core::ops::{Index, IndexMut};
use nalgebra::SVector;
use std::collections::BTreeMap;

/// M on its way: entries that were not written are zero.
#[derive(Debug, Default)]
pub struct LongMass<const N: usize>(BTreeMap<(usize, usize), f64>);

impl<const N: usize> LongMass<N> {
    /// Zeros.
    pub fn zeros() -> Self {
        LongMass(BTreeMap::new())
    }
}

impl<const N: usize> Index<(usize, usize)> for LongMass<N> {
    type Output = f64;

    fn index(&self, place: (usize, usize)) -> &f64 {
        self.0.get(&place).unwrap_or(&0.0)
    }
}

impl<const N: usize> IndexMut<(usize, usize)> for LongMass<N> {
    fn index_mut(&mut self, place: (usize, usize)) -> &mut f64 {
        self.0.entry(place).or_default()
    }
}

/// The factor of a constant mass matrix.
#[derive(Debug, Clone)]
pub struct FactoredMass<const N: usize>(Ldl);

impl<const N: usize> ConstantMass<N> for FactoredMass<N> {
    fn solve(&self, x: &mut SVector<f64, N>) {
        self.0.solve(entries_mut(x));
    }
}

/// The factor of M.
///
/// # Errors
/// [`ParameterError::MassNotPositive`] at the coordinate where M stops being positive definite.
pub fn factored_mass<const N: usize>(
    mass: &mut LongMass<N>,
    coordinates: &[&'static str; N],
) -> Result<FactoredMass<N>, ParameterError> {
    let entries = mass.0.iter();
    let entries = entries.map(|(&(i, j), &value)| (i, j, value));
    let rows = SparseRows::new(N, entries.collect());
    let inverse = |_, pivot, whole| is_positive(pivot, whole).then(|| 1.0 / pivot);
    match Ldl::new(&rows, &inverse) {
        Ok(factor) => Ok(FactoredMass(factor)),
        Err(row) => Err(ParameterError::MassNotPositive {
            coordinate: coordinates[row],
        }),
    }
}
