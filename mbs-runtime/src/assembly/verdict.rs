//! The start of a simulation, with the verdict on its rows and with initial values that are held.

use super::changes;
use super::conditions::{self, Wanted};
use super::guess::{check_guess, check_rows, check_start, check_state, unit_rotations};
use super::held::Start;
use super::independence::independent_rows;
use super::large;
use super::newton::{ASSEMBLED, close, project};
use super::stationary::Nearest;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::large::check_dense_start;
use crate::linear::{Dependence, dot, largest, vector};
use crate::report::HeldGap;
use crate::row_scale::RowScale;
use crate::sink::Diagonal;
use crate::yardstick::Yardstick;
use crate::{
    AssemblyVerdict, Change, Level, Model, OpenRow, Row, Settings, SimulationError, State, System,
};
use nalgebra::SVector;

/// Assembles the declared guess: minimises its mass-weighted change subject to φ(q, 0) = 0, then projects v onto
/// A v + b = 0.
///
/// A guess that satisfies φ = 0 is left as it is. Values that the declaration or `wanted` holds are further equations.
///
/// # Errors
/// [`SimulationError::Assembly`] with the rows that have the largest residuals, [`SimulationError::Held`] with the values
/// that the rows do not allow, and names that the mechanism does not have.
///
/// `ASKED` says whether there may be such values besides the declared ones: without any the code for them is left out.
pub(crate) fn assemble<
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
    const ASKED: bool,
>(
    system: &S,
    settings: &Settings,
    wanted: &[Wanted],
) -> Result<(State<Q, N, R>, AssemblyVerdict), SimulationError> {
    let (guess, declared) = system.guess();
    check_guess(S::MODEL.coordinates, guess.as_slice())?;
    check_guess(S::MODEL.velocities, declared.as_slice())?;
    let guess = unit_rotations(system, &guess)?;
    let fault = |fault| SimulationError::from_fault(fault, S::MODEL, 0.0, settings.step);

    let yardstick = Yardstick::new(system, settings.step);
    let without_dense = const { large::is_possible::<S, Q, N, R>() && S::HELD.is_empty() }
        && wanted.is_empty()
        && large::applies::<S, Q, N, R>(settings);
    if !without_dense {
        check_dense_start(N, R)?;
    }
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    if const { large::is_possible::<S, Q, N, R>() && S::HELD.is_empty() }
        && without_dense
        && let Some(assembled) = large::assemble(
            system,
            settings,
            (0.0, &guess, &declared),
            &yardstick,
            &scale,
        )
    {
        return assembled.map(|(q, v, verdict)| (State::new(0.0, q, v), verdict));
    }
    check_dense_start(N, R)?;
    let mut geometry = ConstraintGeometry::new(system, &guess).map_err(fault)?;
    let mut phi = SVector::zeros();
    geometry
        .evaluate(system, 0.0, &guess, &mut phi)
        .map_err(fault)?;
    let residual_before = largest(&phi);
    let mut q = guess;
    // Conditions on constants, so that what they exclude is not compiled either.
    let conditions = if const { ASKED || !S::HELD.is_empty() } {
        conditions::conditions(system, wanted, &guess)?
    } else {
        Vec::new()
    };
    let start = Start {
        system,
        conditions: &conditions,
        scale: &scale,
        yardstick: &yardstick,
    };
    if const { ASKED || !S::HELD.is_empty() } && start.count(Level::Position) > 0 {
        let placed = start.place(&mut geometry, &guess, &declared);
        let placed = placed.map_err(fault)?;
        q = *placed.as_ref().unwrap_or(&guess);
        let at = geometry.evaluate(system, 0.0, &q, &mut phi);
        at.map_err(fault)?;
        if let Err(open) = placed {
            // Is it the held values, or the joints alone?
            close(system, 0.0, &mut geometry, &mut q, &mut phi, &scale).map_err(fault)?;
            if scale.displacement(&phi) <= ASSEMBLED {
                let rows = independent_rows(system, &geometry, &yardstick);
                let most = freedoms::<S, Q, N, R>(Level::Position, &rows);
                return Err(start.refused(Level::Position, open, most));
            }
        }
    } else {
        close(system, 0.0, &mut geometry, &mut q, &mut phi, &scale).map_err(fault)?;
    }

    let rows = independent_rows(system, &geometry, &yardstick);
    let most = freedoms::<S, Q, N, R>(Level::Velocity, &rows);
    let mut verdict = judge(system, rows, (&phi, &scale), residual_before, [&guess, &q]);
    if !(scale.displacement(&phi) <= ASSEMBLED) {
        return Err(SimulationError::Assembly(verdict));
    }
    let mut v = declared;
    let speed = yardstick.measure(&v);
    project(system, &geometry, &mut v, &scale, speed);
    if const { ASKED || !S::HELD.is_empty() } && start.count(Level::Velocity) > 0 {
        let moving = set_in_motion(&start, &geometry, &q, [&declared, &v]).map_err(fault)?;
        v = moving.map_err(|open| start.refused(Level::Velocity, open, most))?;
    }
    let rates = (&geometry.velocity_rows(system, &v), &geometry.b);
    check_start(system, (0.0, &q, &v), rates, (&scale, &yardstick), settings)?;
    verdict.changes = moved::<S, Q, N, R>([&guess, &q], [&declared, &v], yardstick.length);
    Ok((State::new(0.0, q, v), verdict))
}

/// How many values of a level can be held: as many as rows leave free, of positions the holonomic ones. States are no motion.
fn freedoms<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    level: Level,
    rows: &Dependence,
) -> usize {
    let holonomic = S::MODEL.holonomic_rows();
    let rank = match level {
        Level::Position => (0..holonomic)
            .filter(|row| !rows.dependent.contains(row))
            .count(),
        Level::Velocity => rows.rank,
    };
    N.saturating_sub(S::STATES.len() + rank)
}

/// The verdict on a state from which a simulation resumes; the state is not changed.
pub(crate) fn inspect<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    state: &State<Q, N, R>,
) -> Result<AssemblyVerdict, SimulationError> {
    let q = &state.positions;
    check_state(system, state)?;
    let fault = |fault| SimulationError::from_fault(fault, S::MODEL, state.time, settings.step);
    let yardstick = Yardstick::new(system, settings.step);
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    let mut phi = SVector::zeros();
    system.holonomic(state.time, q, &mut phi);
    check_rows(S::MODEL, &phi, &scale, &settings.method)?;
    let residual = largest(&phi);
    if const { large::is_possible::<S, Q, N, R>() }
        && large::applies::<S, Q, N, R>(settings)
        && let Some(rows) = large::rows(system, state.time, q, &yardstick)
    {
        return Ok(judge(system, rows, (&phi, &scale), residual, [q, q]));
    }
    check_dense_start(N, R)?;
    let mut geometry = ConstraintGeometry::new(system, q).map_err(fault)?;
    geometry
        .evaluate(system, state.time, q, &mut phi)
        .map_err(fault)?;
    let rows = independent_rows(system, &geometry, &yardstick);
    Ok(judge(system, rows, (&phi, &scale), residual, [q, q]))
}

/// What assembly moved.
pub(super) fn moved<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    [guess, q]: [&SVector<f64, Q>; 2],
    [declared, v]: [&SVector<f64, N>; 2],
    length: f64,
) -> Vec<Change> {
    let (before, after) = (guess.as_slice(), q.as_slice());
    let mut changes = changes::changes(S::MODEL.coordinates, before, after, length);
    let (before, after) = (declared.as_slice(), v.as_slice());
    changes.extend(changes::changes(S::MODEL.velocities, before, after, length));
    changes
}

/// The verdict on the pose q, reached from `guess`.
pub(super) fn judge<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    rows: Dependence,
    (phi, scale): (&SVector<f64, R>, &RowScale<R>),
    residual_before: f64,
    [guess, q]: [&SVector<f64, Q>; 2],
) -> AssemblyVerdict {
    let mut change = SVector::zeros();
    let way = system.difference(guess, q);
    system.momentum(q, &way, &mut change);
    let moved = dot(&change, &way).max(0.0);
    let mut mass = Diagonal::<N>::zeros();
    system.mass_matrix(q, &mut mass);
    let total: f64 = mass.0.iter().sum();
    let displacements: SVector<f64, R> = vector(|i| scale.displacement_of(i, phi[i]));
    let worst = worst_rows(
        S::MODEL,
        displacements.as_slice(),
        scale.tolerance.min(ASSEMBLED),
    );
    AssemblyVerdict {
        residual_before,
        residual: largest(phi),
        moved: if total > 0.0 {
            (moved / total).sqrt()
        } else {
            0.0
        },
        rank: rows.rank,
        redundant_rows: names(S::MODEL, &rows.dependent),
        worst_rows: worst
            .iter()
            .map(|&(i, row)| OpenRow {
                name: row.name,
                unit: row.unit,
                residual: phi[i],
            })
            .collect(),
        changes: Vec::new(),
    }
}

/// The holonomic rows that are farthest from satisfied, the worst first. (Not generic: compiled once.)
fn worst_rows<'a>(
    model: &'a Model,
    displacements: &[f64],
    tolerance: f64,
) -> Vec<(usize, &'a Row)> {
    let displacements = displacements.iter().copied().zip(model.rows);
    let mut worst: Vec<_> = displacements
        .enumerate()
        .take(model.structure.holonomic_rows)
        .collect();
    worst.sort_by(|a, b| b.1.0.total_cmp(&a.1.0));
    // One that is not a number counts, too.
    worst.retain(|(_, (displacement, _))| !(*displacement <= tolerance));
    worst.truncate(8);
    worst.iter().map(|(i, (_, row))| (*i, *row)).collect()
}

/// The names of these rows.
fn names(model: &Model, rows: &[usize]) -> Vec<&'static str> {
    rows.iter()
        .filter_map(|&i| Some(model.rows.get(i)?.name))
        .collect()
}

/// The velocities of the start; or the held values that cannot be had, if the rows could be satisfied without them.
fn set_in_motion<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    start: &Start<S, Q, N, R>,
    geometry: &ConstraintGeometry<S, Q, N, R>,
    q: &SVector<f64, Q>,
    [declared, free]: [&SVector<f64, N>; 2],
) -> Result<Result<SVector<f64, N>, Vec<HeldGap>>, Fault> {
    let (system, scale, yardstick) = (start.system, start.scale, start.yardstick);
    let speed = yardstick.measure(declared);
    let violation = |v: &SVector<f64, N>| scale.displacement(&geometry.velocity_rows(system, v));
    let vicinity = start.velocities_around(geometry, (q, free));
    let begin = match &vicinity.aside {
        None => vec![*declared],
        Some(way) => {
            let [one, other] = [free + way, free - way];
            vec![one, other, *declared]
        }
    };
    let mut nearest = Nearest::default();
    for mut v in begin {
        if vicinity.constant.is_empty()
            && let Err(fault) = start.velocities(geometry, q, &mut v)
        {
            nearest.failed(fault);
            continue;
        }
        let prescribed = scale.displacement(&geometry.b).max(start.fastest(q, &v));
        let speed = speed.max(yardstick.measure(&v)).max(prescribed);
        let open = start.open(Level::Velocity, (q, &v), speed, &vicinity);
        let possible = violation(free).max(ASSEMBLED * speed);
        if open.is_empty() && violation(&v) <= possible {
            return Ok(Ok(v));
        }
        nearest.ended(open);
    }
    nearest.open().map(Err)
}
