//! What follows from the equations at acceleration level, at one instant: v̇ and λ, and the outputs and reactions that
//! read them.

#[cfg(feature = "std")]
mod eliminated;

use crate::dynamics::Dynamics;
use crate::fault::Fault;
use crate::linear::zeros;
use crate::singular::WEAK_PIVOT;
use crate::{State, System};
use nalgebra::{SMatrix, SVector};

#[cfg(feature = "std")]
pub(crate) use eliminated::eliminated;

/// The most velocities and rows of a mechanism that has a generated function of v̇ and λ.
const LARGEST: usize = 16;

/// v̇ and λ of M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0.
///
/// By the generated function where there is one and all rows are clearly independent: this allocates nothing. Large
/// mechanisms have their planned elimination, which allocates no dense arrays.
///
/// # Errors
/// A mass matrix that is not positive definite, or rows that admit no finite multiplier.
pub(crate) fn solve<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
) -> Result<(SVector<f64, N>, SVector<f64, R>), Fault> {
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    if let Some(found) = clearly(system, t, q, v)? {
        return Ok(found);
    }
    #[cfg(feature = "std")]
    if let Some(found) = eliminated(system, state) {
        return Ok(found);
    }
    let dynamics = Dynamics::of(system.clone(), t, q, v)?;
    Ok((*dynamics.accelerations(), *dynamics.multipliers()))
}

/// By the generated function; `None` without it, and where a row nearly follows from others.
#[allow(clippy::type_complexity)]
fn clearly<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    q: &SVector<f64, Q>,
    v: &SVector<f64, N>,
) -> Result<Option<(SVector<f64, N>, SVector<f64, R>)>, Fault> {
    if const { N > LARGEST || R > LARGEST } {
        return Ok(None);
    }
    let (mut acceleration, mut lambda, mut inverse_pivot) = (zeros(), zeros(), zeros());
    let (into, none) = (&mut acceleration, zeros());
    if !system.accelerations(t, q, v, &none, into, &mut lambda, &mut inverse_pivot) {
        return Ok(None);
    }
    let lengths = lengths_squared(system, t, q)?;
    let mut pivots = inverse_pivot.iter().zip(&lengths);
    // A row without a pivot has 0 or −1 here.
    let clear =
        pivots.all(|(&inverse, length)| inverse > 0.0 && inverse * length < 1.0 / WEAK_PIVOT);
    let finite = acceleration.iter().chain(&lambda).all(|x| x.is_finite());
    Ok((clear && finite).then_some((acceleration, lambda)))
}

/// a M⁻¹aᵀ of each row, by matrices on the stack.
fn lengths_squared<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    q: &SVector<f64, Q>,
) -> Result<SVector<f64, R>, Fault> {
    let mass = system.factor_mass(q).ok_or(Fault::Mass)?;
    let (mut a, mut w) = (SMatrix::<f64, N, R>::zeros(), SMatrix::zeros());
    let mut delassus = SMatrix::zeros();
    system.constraints(t, q, &mut zeros(), &mut a.data.0, &mut zeros());
    system.metric(&mass, t, q, &a, &mut w, &mut delassus);
    Ok(delassus.diagonal())
}

/// The outputs at a state. If there is no v̇, those that read it are NaN.
pub(crate) fn outputs<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
    outputs: &mut [f64],
) {
    let (t, q, v) = (state.time, &state.positions, &state.velocities);
    if !S::HAS_OUTPUTS_AT_ACCELERATION_LEVEL {
        return system.outputs(t, q, v, outputs);
    }
    match solve(system, state) {
        Ok((acceleration, lambda)) => {
            system.outputs_at_acceleration_level(t, q, v, &acceleration, &lambda, outputs);
        }
        Err(_) => {
            outputs.fill(f64::NAN);
            system.outputs(t, q, v, outputs);
        }
    }
}
