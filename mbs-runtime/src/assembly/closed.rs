//! The start of a simulation without lists: of rows, of coordinates that were moved, of values that are held.

use super::guess::{
    check_guess, check_rates, check_rows, check_start, check_state, unit_rotations,
};
use super::newton::{ASSEMBLED, close, project};
use crate::constraint_geometry::ConstraintGeometry;
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{Settings, SimulationError, State, System};
use nalgebra::SVector;

/// The declared guess, with its rows closed and its velocities projected: the state of
/// [`assemble`](super::assemble) where no value is held.
///
/// # Errors
/// A guess that is not finite, that cannot be assembled, or of which the declaration holds values.
pub(crate) fn closed<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
) -> Result<State<Q, N, R>, SimulationError> {
    if let Some(held) = S::HELD.first() {
        return Err(SimulationError::HeldStart { name: held.name });
    }
    let (guess, mut v) = system.guess();
    check_guess(S::MODEL.coordinates, guess.as_slice())?;
    check_guess(S::MODEL.velocities, v.as_slice())?;
    let mut q = unit_rotations(system, &guess)?;
    let fault = |fault| SimulationError::from_fault(fault, S::MODEL, 0.0, settings.step);
    let yardstick = Yardstick::new(system, settings.step);
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    let mut geometry = ConstraintGeometry::new(system, &q).map_err(fault)?;
    let mut phi = SVector::zeros();
    let at = geometry.evaluate(system, 0.0, &q, &mut phi);
    at.map_err(fault)?;
    close(system, 0.0, &mut geometry, &mut q, &mut phi, &scale).map_err(fault)?;
    if !(scale.displacement(&phi) <= ASSEMBLED) {
        let off = |i: &usize| scale.displacement_of(*i, phi[*i]);
        let worst = (0..R).max_by(|i, j| off(i).total_cmp(&off(j)));
        let row = worst.and_then(|i| S::MODEL.rows.get(i));
        return Err(SimulationError::NotAssembled {
            row: row.map_or("unnamed row", |row| row.name),
            residual: worst.map_or(f64::NAN, |i| phi[i]),
        });
    }
    let speed = yardstick.measure(&v);
    project(system, &geometry, &mut v, &scale, speed);
    let rates = (&geometry.velocity_rows(system, &v), &geometry.b);
    check_start(system, (0.0, &q, &v), rates, (&scale, &yardstick), settings)?;
    Ok(State::new(0.0, q, v))
}

/// Refuses a state that is not finite or does not satisfy the rows.
pub(crate) fn check<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    state: &State<Q, N, R>,
) -> Result<(), SimulationError> {
    check_state(system, state)?;
    let (t, q) = (state.time, &state.positions);
    let fault = |fault| SimulationError::from_fault(fault, S::MODEL, t, settings.step);
    let yardstick = Yardstick::new(system, settings.step);
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    let mut geometry = ConstraintGeometry::new(system, q).map_err(fault)?;
    let mut phi = SVector::zeros();
    let at = geometry.evaluate(system, t, q, &mut phi);
    at.map_err(fault)?;
    check_rows(S::MODEL, &phi, &scale, &settings.method)?;
    let rates = geometry.velocity_rows(system, &state.velocities);
    let speed = yardstick.measure(&state.velocities);
    check_rates(S::MODEL, &rates, &scale, (settings, speed))
}
