//! Rows that change during a run: where an input jumps or a parameter changes, the mechanism follows at once.

use super::continuation::{follow_branch, is_far};
use super::guess::check_start;
use super::independence::independent_rows;
use super::large;
use super::newton::{ASSEMBLED, close, project};
use super::verdict::{judge, moved};
use crate::constraint_geometry::ConstraintGeometry;
use crate::large::check_dense_start;
use crate::linear::largest;
use crate::memory::Box;
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{AssemblyVerdict, Settings, SimulationError, State, System};
use nalgebra::SVector;

/// Moves the positions of a state to near ones with φ(q, t) = 0, and the velocities to the nearest ones with A v + b = 0. A state
/// that satisfies the rows is left as it is. Rows that are far from closed are closed little by little, on the branch of the state.
///
/// # Errors
/// [`SimulationError::NoPose`] where no pose satisfies the rows, [`SimulationError::Contradiction`] where no velocities do,
/// forces and energies that are not finite, and [`SimulationError::Large`] where that takes dense arrays for which a stack has no
/// room; the state is not changed.
#[inline(never)]
pub(crate) fn jump<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    state: &mut State<Q, N, R>,
) -> Result<(), SimulationError> {
    let at = follow(system, settings, state).map_err(|error| of_change(error, "inputs"))?;
    (state.positions, state.velocities) = (at.q, at.v);
    Ok(())
}

/// The same, with the verdict on the rows and on what has moved.
///
/// # Errors
/// As [`jump`].
pub(crate) fn refit<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    state: &mut State<Q, N, R>,
) -> Result<AssemblyVerdict, SimulationError> {
    let found = follow(system, settings, state);
    let At { q, v, rows } = found.map_err(|error| of_change(error, "parameters"))?;
    let verdict = match rows {
        Rows::Judged(verdict) => verdict,
        Rows::Dense(rows) => {
            let positions = [&state.positions, &q];
            let (velocities, length) = ([&state.velocities, &v], rows.yardstick.length);
            let mut verdict = rows.verdict(system, positions);
            verdict.changes = moved::<S, Q, N, R>(positions, velocities, length);
            verdict
        }
    };
    (state.positions, state.velocities) = (q, v);
    Ok(verdict)
}

/// The error of a search that begins with the present pose, after a change of inputs or parameters: here the declaration is not at fault.
fn of_change(error: SimulationError, changed: &'static str) -> SimulationError {
    match error {
        SimulationError::Assembly(verdict) => SimulationError::NoPose {
            changed,
            verdict: Box::new(verdict),
        },
        error => error,
    }
}

/// Where a search for a pose has ended.
struct At<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    q: SVector<f64, Q>,
    v: SVector<f64, N>,
    rows: Rows<S, Q, N, R>,
}

/// The rows there.
enum Rows<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    /// Of a large mechanism, whose factors have given the verdict.
    Judged(AssemblyVerdict),
    Dense(Dense<S, Q, N, R>),
}

/// The rows as dense arrays.
struct Dense<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    yardstick: Yardstick<Q, N>,
    scale: RowScale<R>,
    geometry: Box<ConstraintGeometry<S, Q, N, R>>,
    phi: SVector<f64, R>,
    /// max |φ| before.
    before: f64,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Dense<S, Q, N, R> {
    fn verdict(&self, system: &S, positions: [&SVector<f64, Q>; 2]) -> AssemblyVerdict {
        let rows = independent_rows(system, &self.geometry, &self.yardstick);
        let residual = (&self.phi, &self.scale);
        judge(system, rows, residual, self.before, positions)
    }
}

fn follow<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    state: &State<Q, N, R>,
) -> Result<At<S, Q, N, R>, SimulationError> {
    let t = state.time;
    let fault = |fault| SimulationError::from_fault(fault, S::MODEL, t, settings.step);
    let without_dense =
        const { large::is_possible::<S, Q, N, R>() } && large::applies::<S, Q, N, R>(settings);
    if !without_dense {
        check_dense_start(N, R)?;
    }
    let yardstick = Yardstick::new(system, settings.step);
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    let mut phi = SVector::zeros();
    system.holonomic(t, &state.positions, &mut phi);
    let is_dense = is_far(&phi, &scale) && check_dense_start(N, R).is_ok();
    if const { large::is_possible::<S, Q, N, R>() } && without_dense && !is_dense {
        let before = (t, &state.positions, &state.velocities);
        if let Some(found) = large::assemble(system, settings, before, &yardstick, &scale) {
            let (q, v, verdict) = found?;
            let rows = Rows::Judged(verdict);
            return Ok(At { q, v, rows });
        }
        check_dense_start(N, R)?;
    }
    let (mut q, mut v) = (state.positions, state.velocities);
    let mut geometry = ConstraintGeometry::new(system, &q).map_err(fault)?;
    geometry.evaluate(system, t, &q, &mut phi).map_err(fault)?;
    let before = largest(&phi);
    if follow_branch(system, t, &mut geometry, (&mut q, &phi), &scale).map_err(fault)? {
        geometry.evaluate(system, t, &q, &mut phi).map_err(fault)?;
    }
    close(system, t, &mut geometry, &mut q, &mut phi, &scale).map_err(fault)?;
    let rows = Dense {
        yardstick,
        scale,
        geometry,
        phi,
        before,
    };
    if !(rows.scale.displacement(&rows.phi) <= ASSEMBLED) {
        let verdict = rows.verdict(system, [&state.positions, &q]);
        return Err(SimulationError::Assembly(verdict));
    }
    let speed = rows.yardstick.measure(&v);
    project(system, &rows.geometry, &mut v, &rows.scale, speed);
    let rates = (&rows.geometry.velocity_rows(system, &v), &rows.geometry.b);
    let measures = (&rows.scale, &rows.yardstick);
    check_start(system, (t, &q, &v), rates, measures, settings)?;
    let rows = Rows::Dense(rows);
    Ok(At { q, v, rows })
}
