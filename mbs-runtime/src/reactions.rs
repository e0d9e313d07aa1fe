//! Multipliers and joint reactions at an instant, from the equations at acceleration level.

use crate::assembly::independent_rows;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::free::free;
use crate::linear::{DelassusFactor, accumulate, dot, finite, vector};
use crate::sink::Discard;
use crate::yardstick::Yardstick;
use crate::{Reactions, State, System};
use nalgebra::SVector;

/// Solves M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0 and maps λ to the joints.
///
/// With F = f + ∂T/∂q the first reads M v̇ = F − (∂p/∂q) v + Aᵀλ, which needs no affinities.
pub(crate) fn reactions<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
    step: f64,
) -> Result<Reactions, Fault> {
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    let mut geometry = ConstraintGeometry::new(system, q)?;
    geometry.evaluate(system, t, q, &mut SVector::zeros())?;

    let mut acceleration = free(system, &geometry.mass, t, q, v);
    let mut gamma = SVector::zeros();
    system.constraint_rates(t, q, v, &mut Discard, &mut gamma);
    let mut solver = Box::new(DelassusFactor::new());
    solver.factor(&geometry.delassus);
    let mut lambda = SVector::zeros();
    // The second pass is a correction where the proximal solve was needed, and round-off elsewhere.
    for _ in 0..2 {
        let mut change: SVector<f64, R> =
            vector(|i| -gamma[i] - dot(&geometry.a[i], &acceleration));
        solver.solve(&mut change);
        accumulate(&mut acceleration, &geometry.w, &change);
        for i in 0..R {
            lambda[i] += change[i];
        }
    }
    if !finite(&acceleration) || !finite(&lambda) {
        return Err(Fault::NonFinite("reactions"));
    }
    let mut values = vec![0.0; S::MODEL.reactions.len()];
    system.reactions(t, q, v, &acceleration, &lambda, &mut values);
    Ok(Reactions {
        unique: !solver.regularised
            && !S::MODEL.leaves_rows_out()
            && independent_rows(system, &geometry, &Yardstick::new(system, step))
                .dependent
                .is_empty(),
        values,
        multipliers: lambda.as_slice().to_vec(),
    })
}
