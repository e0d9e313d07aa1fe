//! What a guess or a state has to be before its rows are closed: finite, with unit quaternions.

use crate::row_scale::RowScale;
use crate::{Coordinate, Model, Settings, SimulationError, State, System};
use nalgebra::SVector;

/// Violation of a row, as a displacement relative to the size of the mechanism, with which a state can be resumed.
const RESUMABLE: f64 = 1e-6;

/// Refuses a state that is not finite, or whose quaternions have not unit length.
pub(super) fn check_state<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
) -> Result<(), SimulationError> {
    check_finite("time", &[state.time])?;
    check_finite("a coordinate", state.positions.as_slice())?;
    check_finite("a velocity", state.velocities.as_slice())?;
    check_finite("a multiplier", state.multipliers.as_slice())?;
    check_finite(
        "a change of a multiplier",
        state.multiplier_changes.as_slice(),
    )?;
    let q = &state.positions;
    let unit = unit_rotations(system, q)?;
    for (given, unit) in q.iter().zip(unit.iter()) {
        if (given - unit).abs() > 1e-6 {
            return Err(not_unit(given / unit));
        }
    }
    Ok(())
}

/// Refuses residuals φ of a state that does not satisfy the rows.
pub(super) fn check_rows<const R: usize>(
    model: &Model,
    phi: &SVector<f64, R>,
    scale: &RowScale<R>,
) -> Result<(), SimulationError> {
    for (i, row) in model.rows.iter().enumerate() {
        if scale.displacement_of(i, phi[i]) > RESUMABLE {
            return Err(SimulationError::State {
                what: row.name,
                value: phi[i],
            });
        }
    }
    Ok(())
}

/// Refuses rates A v + b of a state with this speed, in lengths of the mechanism or radians a second, that does not
/// satisfy the rows.
pub(crate) fn check_rates<const R: usize>(
    model: &Model,
    rates: &SVector<f64, R>,
    scale: &RowScale<R>,
    (settings, speed): (&Settings, f64),
) -> Result<(), SimulationError> {
    // What moves a row by less than its tolerance in a step is allowed at rest, too.
    let least = settings.constraint_tolerance / settings.step;
    let allowed = (RESUMABLE * speed).max(least);
    for (i, (row, value)) in model.rows.iter().zip(rates.iter().copied()).enumerate() {
        if scale.displacement_of(i, value) > allowed {
            return Err(SimulationError::State {
                what: row.name,
                value,
            });
        }
    }
    Ok(())
}

/// q with unit quaternions; refused where one is zero.
pub(super) fn unit_rotations<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q: &SVector<f64, Q>,
) -> Result<SVector<f64, Q>, SimulationError> {
    let unit = system.advance(q, &SVector::zeros(), 0.0);
    match unit.iter().all(|value| value.is_finite()) {
        true => Ok(unit),
        false => Err(not_unit(0.0)),
    }
}

fn not_unit(value: f64) -> SimulationError {
    SimulationError::State {
        what: "length of a unit quaternion",
        value,
    }
}

/// The declared guess, by the names of its coordinates or velocities.
pub(super) fn check_guess(named: &[Coordinate], values: &[f64]) -> Result<(), SimulationError> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(i) => Err(SimulationError::Guess {
            what: named.get(i).map_or("a coordinate", |named| named.name),
            value: values[i],
        }),
        None => Ok(()),
    }
}

fn check_finite(what: &'static str, values: &[f64]) -> Result<(), SimulationError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(&value) => Err(SimulationError::State { what, value }),
        None => Ok(()),
    }
}
