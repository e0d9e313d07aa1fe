//! The factor of a mass matrix that depends on the configuration.

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

/// M = L Lᵀ, with the inverse diagonal kept.
#[derive(Debug, Clone)]
pub struct Cholesky<const N: usize> {
    lower: [[f64; N]; N],
    inverse_diagonal: [f64; N],
}

impl<const N: usize> Cholesky<N> {
    /// The factor of M; `None` if M is not positive definite.
    #[inline]
    pub fn new(mass: &SMatrix<f64, N, N>) -> Option<Self> {
        Self::factor(mass).ok()
    }

    /// The factor of M, of which the upper triangle is read.
    ///
    /// # Errors
    /// The column at which M stops being positive definite (to 1/[`WEAKEST`] of its diagonal).
    #[inline]
    pub fn factor(mass: &SMatrix<f64, N, N>) -> Result<Self, usize> {
        // M is symmetric: its columns are its rows.
        let mass = &mass.data.0;
        let mut lower = *mass;
        let mut inverse_diagonal = [0.0; N];
        for k in 0..N {
            let mut pivot = lower[k][k];
            for j in 0..k {
                pivot -= lower[k][j] * lower[k][j];
            }
            // Written so that NaN is refused, too.
            if !(pivot * WEAKEST > mass[k][k] && pivot.is_finite()) {
                return Err(k);
            }
            let inverse = 1.0 / pivot.sqrt();
            inverse_diagonal[k] = inverse;
            for i in k + 1..N {
                let mut entry = lower[i][k];
                for j in 0..k {
                    entry -= lower[i][j] * lower[k][j];
                }
                lower[i][k] = entry * inverse;
            }
        }
        Ok(Cholesky {
            lower,
            inverse_diagonal,
        })
    }

    /// x ← M⁻¹ x.
    #[inline]
    pub fn solve(&self, x: &mut SVector<f64, N>) {
        let [x] = &mut x.data.0;
        for i in 0..N {
            let mut value = x[i];
            for j in 0..i {
                value -= self.lower[i][j] * x[j];
            }
            x[i] = value * self.inverse_diagonal[i];
        }
        for i in (0..N).rev() {
            let mut value = x[i];
            for j in i + 1..N {
                value -= self.lower[j][i] * x[j];
            }
            x[i] = value * self.inverse_diagonal[i];
        }
    }
}
