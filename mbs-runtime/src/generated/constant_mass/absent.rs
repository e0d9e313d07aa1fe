//! Without the feature `std` there are no lists: a long mass matrix is inverted like others.

use super::ConstantMass;
use crate::ParameterError;
use crate::generated::{clear_mass, inverse_mass};
use crate::memory::Box;
use core::ops::{Index, IndexMut};
use nalgebra::{SMatrix, SVector};

/// M on its way.
#[derive(Debug)]
pub struct LongMass<const N: usize>(Box<SMatrix<f64, N, N>>);

impl<const N: usize> LongMass<N> {
    /// Zeros.
    pub fn zeros() -> Self {
        LongMass(clear_mass())
    }
}

impl<const N: usize> Index<(usize, usize)> for LongMass<N> {
    type Output = f64;

    fn index(&self, place: (usize, usize)) -> &f64 {
        &self.0[place]
    }
}

impl<const N: usize> IndexMut<(usize, usize)> for LongMass<N> {
    fn index_mut(&mut self, place: (usize, usize)) -> &mut f64 {
        &mut self.0[place]
    }
}

/// The inverse of a constant mass matrix.
#[derive(Debug, Clone)]
pub struct FactoredMass<const N: usize>(Box<SMatrix<f64, N, N>>);

impl<const N: usize> ConstantMass<N> for FactoredMass<N> {
    fn solve(&self, x: &mut SVector<f64, N>) {
        self.0.solve(x);
    }
}

/// M⁻¹.
///
/// # Errors
/// [`ParameterError::MassNotPositive`] at the coordinate where M stops being positive definite.
pub fn factored_mass<const N: usize>(
    mass: &mut LongMass<N>,
    coordinates: &[&'static str; N],
) -> Result<FactoredMass<N>, ParameterError> {
    inverse_mass(&mut mass.0, coordinates).map(FactoredMass)
}
