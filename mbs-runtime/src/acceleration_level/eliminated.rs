//! The same by the planned elimination of a large mechanism, without dense arrays.

use super::LARGEST;
use crate::alf3f::sparse::{Bordered, Rows};
use crate::contract::mass_rows;
use crate::free::write_free_forces;
use crate::linear::{finite, negative, zeros};
use crate::singular::Thresholds;
use crate::sink::Discard;
use crate::{State, System};
use nalgebra::SVector;

/// v̇ and λ; `None` for small mechanisms, where nothing is planned, and where rows depend on others or nearly so.
pub(crate) fn eliminated<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
) -> Option<(SVector<f64, N>, SVector<f64, R>)> {
    let plan = S::ELIMINATION?;
    if N <= LARGEST || plan.redundant > 0 || S::MODEL.leaves_rows_out() {
        return None;
    }
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    let mut matrix = Bordered::new(plan, &mass_rows(system, q), Thresholds::ELIMINATED);
    let (mut phi, mut b) = (zeros(), zeros());
    system.sparse_constraints(t, q, &mut phi, &mut matrix.entries, &mut b);
    if !S::STRUCTURE.constant_mass {
        system.sparse_mass(q, &mut matrix.entries);
    }
    matrix.factor(plan);
    if matrix.all_rows(plan) != Rows::Independent {
        return None;
    }
    let (mut acceleration, mut gamma) = (zeros(), zeros());
    write_free_forces(system, t, q, v, &mut acceleration);
    system.constraint_rates(t, q, v, &mut Discard, &mut gamma);
    let mut lambda = negative(&gamma);
    let mut unknowns = vec![0.0; plan.unknowns];
    matrix.accelerate(plan, &mut unknowns, (&mut acceleration, &mut lambda));
    (finite(&acceleration) && finite(&lambda)).then_some((acceleration, lambda))
}
