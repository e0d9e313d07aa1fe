//! Solutions with a mass matrix that is constant: by its inverse, or by its factor where the system is large.

use crate::linear::entries_mut;
use crate::memory::Box;
use nalgebra::{SMatrix, SVector};

#[cfg(feature = "std")]
mod long;
#[cfg(not(feature = "std"))]
#[path = "constant_mass/absent.rs"]
mod long;

pub use long::{FactoredMass, LongMass, factored_mass};

/// What a system keeps of a constant M.
pub trait ConstantMass<const N: usize> {
    /// x ← M⁻¹x.
    fn solve(&self, x: &mut SVector<f64, N>);

    /// W = M⁻¹Aᵀ from the rows of A.
    #[inline]
    fn solve_rows<const R: usize>(&self, a: &SMatrix<f64, N, R>, w: &mut SMatrix<f64, N, R>) {
        super::solve_rows(a, w, |x| self.solve(x));
    }
}

impl<const N: usize> ConstantMass<N> for SMatrix<f64, N, N> {
    #[inline]
    fn solve(&self, x: &mut SVector<f64, N>) {
        let old = *x;
        let [old] = &old.data.0;
        for (value, row) in entries_mut(x).iter_mut().zip(&self.data.0) {
            *value = row.iter().zip(old).map(|(m, x)| m * x).sum();
        }
    }

    /// Skips the zeros of A.
    #[inline]
    fn solve_rows<const R: usize>(&self, a: &SMatrix<f64, N, R>, w: &mut SMatrix<f64, N, R>) {
        for (w, a) in w.data.0.iter_mut().zip(&a.data.0) {
            *w = [0.0; N];
            for (&entry, column) in a.iter().zip(&self.data.0) {
                if entry != 0.0 {
                    for (w, m) in w.iter_mut().zip(column) {
                        *w += entry * m;
                    }
                }
            }
        }
    }
}

impl<const N: usize, M: ConstantMass<N>> ConstantMass<N> for Box<M> {
    #[inline]
    fn solve(&self, x: &mut SVector<f64, N>) {
        (**self).solve(x);
    }

    #[inline]
    fn solve_rows<const R: usize>(&self, a: &SMatrix<f64, N, R>, w: &mut SMatrix<f64, N, R>) {
        (**self).solve_rows(a, w);
    }
}

/// x ← M⁻¹ x.
pub fn multiply<const N: usize>(inverse: &impl ConstantMass<N>, x: &mut SVector<f64, N>) {
    inverse.solve(x);
}

/// W = M⁻¹Aᵀ from the rows of A.
pub fn multiply_rows<const N: usize, const R: usize>(
    inverse: &impl ConstantMass<N>,
    a: &SMatrix<f64, N, R>,
    w: &mut SMatrix<f64, N, R>,
) {
    inverse.solve_rows(a, w);
}
