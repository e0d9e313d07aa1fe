//! Sparse elimination: the generated functions for large mechanisms.

use nalgebra::SVector;

/// The elimination of
///
/// ```text
/// K = [ M  A₀ᵀ ]
///     [ A₁  0  ]
/// ```
///
/// in an order that was chosen when the mechanism was compiled. K, and then its factor, is an array of its entries and
/// of the fill: for each column the pivot and the entries below it. The entries above the diagonal are at the same
/// indices of another array, or are the same if A₀ = A₁. The pivot of a row that depends on others is set to zero, and
/// its multiplier is zero.
pub struct Elimination<const N: usize, const R: usize> {
    /// N + R.
    pub unknowns: usize,
    /// Length of the array of K.
    pub slots: usize,
    /// The same for M by itself.
    pub mass_slots: usize,
    /// Row, column and slot of the entries of M, lower or upper triangle, in the array of K …
    pub mass: &'static [(usize, usize, usize)],
    /// … and in that of M by itself.
    pub mass_alone: &'static [(usize, usize, usize)],
    /// Of each row of A the columns and slots of the entries that are not zero.
    pub jacobian: &'static [&'static [[u32; 2]]],
    /// Position in the order of elimination of each velocity, then of each row of A.
    pub positions: &'static [u32],
    /// Position of each velocity in the elimination of M by itself.
    pub mass_positions: &'static [u32],
    /// Slot of the pivot of each row of A.
    pub pivots: &'static [usize],
    /// Whether M⁻¹f varies, or is too long to be computed in advance.
    pub forces_vary: bool,
    /// Factors K if A₀ = A₁. Receives in the second array, by position, a M⁻¹aᵀ of each row before other rows were
    /// eliminated; returns the largest ratio of these to the pivots (infinite if a row was left out).
    pub factor: fn(&mut [f64], &mut [f64]) -> f64,
    /// x ← K⁻¹x from a factor; x is in the order of elimination.
    pub solve: fn(&[f64], &mut [f64]),
    /// Factors K from its lower and its upper triangle, where the ratio is taken to the lengths given.
    pub factor_pair: fn(&mut [f64], &mut [f64], &[f64]) -> f64,
    /// The same as `solve`, with both triangles.
    pub solve_pair: fn(&[f64], &[f64], &mut [f64]),
    /// Factors M.
    pub factor_mass: fn(&mut [f64], &mut [f64]) -> f64,
    /// x ← M⁻¹x, in the order of elimination.
    pub solve_mass: fn(&[f64], &mut [f64]),
}

impl<const N: usize, const R: usize> Elimination<N, R> {
    /// A v, from K.
    pub(crate) fn rates(&self, k: &[f64], v: &SVector<f64, N>) -> SVector<f64, R> {
        let mut rates = SVector::<f64, R>::zeros();
        for (rate, row) in rates.iter_mut().zip(self.jacobian) {
            let terms = row
                .iter()
                .map(|&[j, slot]| k[slot as usize] * v[j as usize]);
            *rate = terms.sum();
        }
        rates
    }

    /// Aᵀκ, from K.
    pub(crate) fn impulse(&self, k: &[f64], kappa: &SVector<f64, R>) -> SVector<f64, N> {
        let mut impulse = SVector::<f64, N>::zeros();
        for (kappa, row) in kappa.iter().zip(self.jacobian) {
            for &[j, slot] in *row {
                impulse[j as usize] += k[slot as usize] * kappa;
            }
        }
        impulse
    }

    /// Adds δv and δκ for right-hand sides of the rows; `solve` is x ← K⁻¹x.
    #[inline]
    pub(crate) fn add_solution(
        &self,
        rows: &SVector<f64, R>,
        x: &mut [f64],
        (v, kappa): (&mut SVector<f64, N>, &mut SVector<f64, R>),
        solve: impl FnOnce(&mut [f64]),
    ) {
        let (of_velocities, of_rows) = self.positions.split_at(N);
        x.fill(0.0);
        for (&position, &row) in of_rows.iter().zip(rows) {
            x[position as usize] = row;
        }
        solve(x);
        for (v, &position) in v.iter_mut().zip(of_velocities) {
            *v += x[position as usize];
        }
        for (kappa, &position) in kappa.iter_mut().zip(of_rows) {
            *kappa -= x[position as usize];
        }
    }
}
