//! Rows that follow inputs: where an input jumps, the mechanism follows at once.

use super::newton::{ASSEMBLED, close, project};
use super::verdict::{independent_rows, judge};
use crate::constraint_geometry::ConstraintGeometry;
use crate::linear::largest;
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{Settings, SimulationError, State, System};
use nalgebra::SVector;

/// Moves the positions of a state to the nearest ones with φ(q, t) = 0, and the velocities to the nearest ones with
/// A v + b = 0. A state that satisfies the rows is left as it is.
///
/// # Errors
/// [`SimulationError::Assembly`] where no pose satisfies the rows; the state is not changed.
#[inline(never)]
pub(crate) fn jump<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    state: &mut State<Q, N, R>,
) -> Result<(), SimulationError> {
    let t = state.time;
    let fault = |fault| SimulationError::from_fault(fault, S::MODEL, t, settings.step);
    let yardstick = Yardstick::new(system, settings.step);
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    let (mut q, mut v) = (state.positions, state.velocities);
    let mut geometry = ConstraintGeometry::new(system, &q).map_err(fault)?;
    let mut phi = SVector::zeros();
    geometry.evaluate(system, t, &q, &mut phi).map_err(fault)?;
    let before = largest(&phi);
    close(system, t, &mut geometry, &mut q, &mut phi, &scale).map_err(fault)?;
    if !(scale.displacement(&phi) <= ASSEMBLED) {
        let rows = independent_rows(system, &geometry, &yardstick);
        let verdict = judge(system, rows, (&phi, &scale), before, [&state.positions, &q]);
        return Err(SimulationError::Assembly(verdict));
    }
    let speed = yardstick.measure(&v);
    project(system, &geometry, &mut v, &scale, speed);
    (state.positions, state.velocities) = (q, v);
    Ok(())
}
