//! The lengths of the rows of a large mechanism, from the entries of A alone.

use super::RowScale;
use crate::contract::{constraint_rows, mass_rows};
use crate::large::{is_sparse, starts_sparse};
use crate::linear::{vector, zeros};
use crate::yardstick::Yardstick;
use crate::{Settings, System};
use nalgebra::SVector;

/// |a_i|² in the units of the yardstick and a M⁻¹aᵀ of the rows at the declared guess; `None` where the second is needed,
/// and no elimination is planned. (It is zero, and not used, with the sparse factors of the implicit flow.)
pub(super) fn lengths<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    yardstick: &Yardstick<Q, N>,
    settings: &Settings,
) -> Option<[SVector<f64, R>; 2]> {
    if !const { starts_sparse::<N, R>() } {
        return None;
    }
    let (q, _) = system.guess();
    let usual = match S::ELIMINATION {
        _ if is_sparse::<S, Q, N, R>(settings) => zeros(),
        Some(plan) => {
            let mut k = plan.matrix(&mass_rows(system, &q));
            system.sparse_constraints(0.0, &q, &mut zeros(), &mut k, &mut zeros());
            let mut lengths = vec![0.0; plan.unknowns];
            (plan.factor)(&mut k, &mut lengths);
            vector(|i| match i < S::STRUCTURE.holonomic_rows {
                true => lengths[plan.pivots[i].0],
                false => 0.0,
            })
        }
        None => return None,
    };
    let a = constraint_rows(system, 0.0, &q);
    let lengths = vector(|i| yardstick.length_squared(a.row(i)));
    Some([lengths, usual])
}

impl<const R: usize> RowScale<R> {
    /// Whether a row with these entries is zero except for round-off.
    pub(crate) fn vanishes<S: System<Q, N, R>, const Q: usize, const N: usize>(
        yardstick: &Yardstick<Q, N>,
        row: usize,
        entries: impl Iterator<Item = (usize, f64)>,
    ) -> bool {
        let expected = Self::expected::<S, Q, N>(row, yardstick.length);
        yardstick.length_squared(entries) <= (crate::singular::NOTHING * expected).powi(2)
    }
}
