//! Joint reactions at an instant, from the equations at acceleration level.

use crate::assembly::independent_rows;
use crate::dynamics::Dynamics;
use crate::fault::Fault;
use crate::yardstick::Yardstick;
use crate::{Reactions, State, System};

/// Maps λ of M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0 to the joints.
pub(crate) fn reactions<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
    step: f64,
) -> Result<Reactions, Fault> {
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    let dynamics = Dynamics::of(system.clone(), t, q, v)?;
    let (acceleration, lambda) = (dynamics.accelerations(), dynamics.multipliers());
    let mut values = vec![0.0; S::MODEL.reactions.len()];
    system.reactions(t, q, v, acceleration, lambda, &mut values);
    let geometry = &dynamics.geometry;
    Ok(Reactions {
        unique: !dynamics.solver.regularised
            && !S::MODEL.leaves_rows_out()
            && independent_rows(system, geometry, &Yardstick::new(system, step))
                .dependent
                .is_empty(),
        values,
        multipliers: lambda.as_slice().to_vec(),
    })
}
