//! Sparse elimination: the generated functions for large mechanisms.

#[cfg(feature = "std")]
use crate::linear::sparse::SparseRows;
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
#[derive(Debug)]
pub struct Elimination<const N: usize, const R: usize> {
    /// N + R.
    pub unknowns: usize,
    /// Length of the array of K, with room for a spread column where the elimination is by a table.
    pub slots: usize,
    /// Row, column and slot of the entries of M, lower or upper triangle.
    pub mass: &'static [(usize, usize, usize)],
    /// Position in the order of elimination, and slot of the pivot, of each row of A, in the order of rows.
    pub pivots: &'static [(usize, usize)],
    /// How many rows follow from others.
    pub redundant: usize,
    /// Operations of a factor and of a solution, in those of dense arrays.
    pub operations: [u64; 2],
    /// A v, from K.
    pub rates: Rates<N, R>,
    /// Aᵀκ, from K.
    pub impulse: fn(&[f64], &SVector<f64, R>, &mut SVector<f64, N>),
    /// Factors K if A₀ = A₁. Receives in the second array, by position, a M⁻¹aᵀ of each row before other rows were
    /// eliminated; returns the largest ratio of these to the pivots (infinite if a row was left out).
    pub factor: fn(&mut [f64], &mut [f64]) -> f64,
    /// From a factor and the right-hand sides of the rows, by way of an array of N + R: adds δv and δκ.
    pub solve: fn(&[f64], &SVector<f64, R>, &mut [f64], &mut SVector<f64, N>, &mut SVector<f64, R>),
    /// From a factor, by way of an array of N + R: F − ṗ|_v becomes v̇, and −γ becomes λ.
    pub accelerate: fn(&[f64], &mut [f64], &mut SVector<f64, N>, &mut SVector<f64, R>),
    /// What the kicks of the two-level step need beside, where M is constant, forces depend on positions only, and all rows
    /// are holonomic.
    pub kicks: Option<Kicks<N, R>>,
}

/// Eliminations of K with the rows of two instants, and of M by itself.
#[derive(Debug)]
pub struct Kicks<const N: usize, const R: usize> {
    /// Length of the array of M by itself, with the same room as that of K.
    pub mass_slots: usize,
    /// Row, column and slot in it of the entries of M.
    pub mass: &'static [(usize, usize, usize)],
    /// Whether M⁻¹f varies, or is too long to be computed in advance.
    pub forces_vary: bool,
    /// Factors K from its lower and its upper triangle, where the ratio is taken to the lengths given.
    pub factor_pair: fn(&mut [f64], &mut [f64], &[f64]) -> f64,
    /// The same as [`Elimination::solve`], with both triangles.
    pub solve_pair: fn(
        &[f64],
        &[f64],
        &SVector<f64, R>,
        &mut [f64],
        &mut SVector<f64, N>,
        &mut SVector<f64, R>,
    ),
    /// Factors M.
    pub factor_mass: fn(&mut [f64], &mut [f64]) -> f64,
    /// x ← M⁻¹x by way of an array of N.
    pub solve_mass: fn(&[f64], &mut [f64], &mut SVector<f64, N>),
}

#[cfg(feature = "std")]
impl<const N: usize, const R: usize> Elimination<N, R> {
    /// The array of K with M and no rows.
    pub(crate) fn matrix(&self, mass: &SparseRows) -> Box<[f64]> {
        let mut entries = vec![0.0; self.slots].into_boxed_slice();
        for &(i, j, slot) in self.mass {
            entries[slot] = mass.get(i, j);
        }
        entries
    }
}

/// A v, from K.
pub type Rates<const N: usize, const R: usize> = fn(&[f64], &SVector<f64, N>, &mut SVector<f64, R>);
