//! All equations of a mechanism.

use super::{Configuration, Constraints, Loads, Observables};
use crate::{Model, Structure};
use nalgebra::SVector;

/// The equations of a mechanism for one set of parameters, with Q coordinates, N velocities and R constraint
/// rows.
pub trait System<const Q: usize, const N: usize, const R: usize>:
    Configuration<Q, N>
    + Constraints<Q, N, R>
    + Loads<Q, N>
    + Observables<Q, N, R>
    + Send
    + Sync
    + 'static
{
    /// The summary of the model.
    const MODEL: &'static Model;
    /// Properties of the equations that integrators use.
    const STRUCTURE: Structure;
    /// Whether there is a function [`Self::partitioned_accelerations`].
    const PARTITIONED: bool = false;

    /// v̇ and λ of M v̇ + ṗ|_v = F + Aᵀλ, A v̇ + γ + `correction` = 0. A row that follows from others ([`Model::mobility`](crate::Model::mobility), or
    /// a singular pose) has λ = 0 and is not asked for: v̇ is the same whatever the division of the work, λ is not that of
    /// minimum norm. `inverse_pivot` of a row is that of its pivot in A M⁻¹Aᵀ: 0 if the row was passed over here, −1 if it
    /// follows from others in every pose. Generated where it is straight-line code of bearable length; else it computes
    /// nothing and answers `false`.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn accelerations(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        correction: &SVector<f64, R>,
        acceleration: &mut SVector<f64, N>,
        lambda: &mut SVector<f64, R>,
        inverse_pivot: &mut SVector<f64, R>,
    ) -> bool {
        let _ = (t, q, v, correction, acceleration, lambda, inverse_pivot);
        false
    }

    /// v̇ of the same equations by independent velocities, without multipliers, for mechanisms of few degrees of freedom.
    /// `weakness` of a row: the reciprocal of the squared determinant of the block that determines velocities from it, relative
    /// to its usual size; large beside singular poses and dead points, where v̇ has to be computed otherwise. Entries that
    /// are not written stay as they are. Generated where this takes fewer operations ([`Self::PARTITIONED`]); else it computes
    /// nothing and answers `false`.
    #[inline(always)]
    fn partitioned_accelerations(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        correction: &SVector<f64, R>,
        acceleration: &mut SVector<f64, N>,
        weakness: &mut SVector<f64, R>,
    ) -> bool {
        let _ = (t, q, v, correction, acceleration, weakness);
        false
    }
}
