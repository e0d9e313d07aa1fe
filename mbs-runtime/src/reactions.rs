//! Joint reactions at an instant, from the equations at acceleration level.

use crate::acceleration_level;
use crate::assembly::{independent_rows, vanishes};
use crate::dynamics::Dynamics;
use crate::fault::Fault;
use crate::yardstick::Yardstick;
use crate::{Reactions, State, System};
use nalgebra::SVector;

/// Maps λ of M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0 to the joints.
pub(crate) fn reactions<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
    step: f64,
) -> Result<Reactions, Fault> {
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    let of = |acceleration: &SVector<f64, N>, lambda: &SVector<f64, R>, unique: bool| {
        let mut values = vec![0.0; S::MODEL.reactions.len()];
        system.reactions(t, q, v, acceleration, lambda, &mut values);
        Reactions {
            unique,
            values,
            multipliers: lambda.as_slice().to_vec(),
        }
    };
    if let Some((acceleration, lambda)) = acceleration_level::eliminated(system, state) {
        return Ok(of(&acceleration, &lambda, true));
    }
    let dynamics = Dynamics::of(system.clone(), t, q, v)?;
    let unique = is_unique(&dynamics, &Yardstick::new(system, step));
    Ok(of(dynamics.accelerations(), dynamics.multipliers(), unique))
}

/// The most components of a mechanism whose reactions are evaluated on the stack.
const FEW: usize = 256;

/// One component of [`reactions`].
pub(crate) fn reaction<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
    index: usize,
) -> Result<f64, Fault> {
    let (acceleration, lambda) = acceleration_level::solve(system, state)?;
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    let read = |values: &mut [f64]| {
        system.reactions(t, q, v, &acceleration, &lambda, values);
        // As many values as the model names.
        values.get(index).copied().unwrap_or(f64::NAN)
    };
    let count = const { S::MODEL.reactions.len() };
    match count > FEW {
        true => Ok(read(&mut vec![0.0; count])),
        false => Ok(read(&mut [0.0; FEW][..count])),
    }
}

/// Whether the rows are independent, so that there is one solution for λ.
fn is_unique<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    dynamics: &Dynamics<S, Q, N, R>,
    yardstick: &Yardstick<Q, N>,
) -> bool {
    let (geometry, solver) = (&dynamics.geometry, &dynamics.solver);
    if solver.regularised || S::MODEL.leaves_rows_out() {
        return false;
    }
    // Pivots that are far from round-off leave no doubt; otherwise the rows themselves are compared.
    let clear = !solver.weak && !(0..R).any(|row| vanishes(geometry, yardstick, row));
    clear
        || independent_rows(&dynamics.system, geometry, yardstick)
            .dependent
            .is_empty()
}
