//! From the declared guess to a state that satisfies the constraints.

mod changes;
mod closing;
mod conditions;
mod continuation;
mod differences;
mod held;
#[cfg(feature = "sparse")]
mod large;

use self::held::Start;
use crate::alf3f::residual_of;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
#[cfg(feature = "sparse")]
use crate::large::is_sparse;
use crate::linear::Dependence;
use crate::linear::{
    DelassusFactor, RowMatrix, accumulate, dependence, dot, largest, negative, vector,
};
use crate::report::HeldGap;
use crate::row_scale::RowScale;
use crate::singular::NOTHING;
use crate::sink::Diagonal;
use crate::yardstick::Yardstick;
use crate::{
    AssemblyVerdict, Change, Coordinate, Level, Model, Settings, SimulationError, State, System,
};
pub(crate) use conditions::Wanted;
use nalgebra::SVector;

/// Newton steps of the position problem; each is damped until it reduces the residual.
const MAX_ITERATIONS: usize = 60;
/// Violation of a row, as a displacement relative to the size of the mechanism, above which a guess counts as not assembled.
const ASSEMBLED: f64 = 1e-9;
/// The same with which a state can be resumed.
pub(crate) const RESUMABLE: f64 = 1e-6;

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
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    #[cfg(feature = "sparse")]
    if S::HELD.is_empty()
        && wanted.is_empty()
        && is_sparse::<S, Q, N, R>(settings)
        && let Some(assembled) = large::assemble(system, &guess, &declared, &yardstick, &scale)
    {
        return Ok(assembled);
    }
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
        let at = start.positions(&mut geometry, &mut q, &declared);
        at.map_err(fault)?;
        let open = start.open(Level::Position, &q, &declared, 1.0);
        system.holonomic(0.0, &q, &mut phi);
        if !open.is_empty() || !(scale.displacement(&phi) <= ASSEMBLED) {
            // Is it the held values, or the joints alone?
            q = guess;
            let at = geometry.evaluate(system, 0.0, &q, &mut phi);
            at.map_err(fault)?;
            close(system, &mut geometry, &mut q, &mut phi, &scale).map_err(fault)?;
            if scale.displacement(&phi) <= ASSEMBLED {
                let rank = independent_rows(system, &geometry, &yardstick).rank;
                return Err(start.refused(Level::Position, open, N.saturating_sub(rank)));
            }
        }
    } else {
        close(system, &mut geometry, &mut q, &mut phi, &scale).map_err(fault)?;
    }

    let rows = independent_rows(system, &geometry, &yardstick);
    let mut verdict = judge(system, rows, (&phi, &scale), residual_before, [&guess, &q]);
    if !(scale.displacement(&phi) <= ASSEMBLED) {
        return Err(SimulationError::Assembly(verdict));
    }
    let freedoms = N.saturating_sub(verdict.rank);
    let mut v = declared;
    let speed = yardstick.measure(&v);
    project(system, &geometry, &mut v, &scale, speed);
    if const { ASKED || !S::HELD.is_empty() } && start.count(Level::Velocity) > 0 {
        let moving = set_in_motion(&start, &geometry, &q, [&declared, &v]).map_err(fault)?;
        v = moving.map_err(|open| start.refused(Level::Velocity, open, freedoms))?;
    }
    verdict.changes = moved::<S, Q, N, R>([&guess, &q], [&declared, &v], yardstick.length);
    Ok((State::new(0.0, q, v), verdict))
}

/// What assembly moved.
fn moved<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
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

/// The verdict on a state from which a simulation resumes; the state is not changed.
pub(crate) fn inspect<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    state: &State<Q, N, R>,
) -> Result<AssemblyVerdict, SimulationError> {
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
    let fault = |fault| SimulationError::from_fault(fault, S::MODEL, state.time, settings.step);
    let yardstick = Yardstick::new(system, settings.step);
    let scale = RowScale::new(system, &yardstick, settings).map_err(fault)?;
    let mut phi = SVector::zeros();
    system.holonomic(state.time, q, &mut phi);
    for (i, row) in S::MODEL.rows.iter().enumerate() {
        if scale.displacement_of(i, phi[i]) > RESUMABLE {
            return Err(SimulationError::State {
                what: row.name,
                value: phi[i],
            });
        }
    }
    let residual = largest(&phi);
    #[cfg(feature = "sparse")]
    if is_sparse::<S, Q, N, R>(settings)
        && let Some(rows) = large::rows(system, state.time, q)
    {
        return Ok(judge(system, rows, (&phi, &scale), residual, [q, q]));
    }
    let mut geometry = ConstraintGeometry::new(system, q).map_err(fault)?;
    geometry
        .evaluate(system, state.time, q, &mut phi)
        .map_err(fault)?;
    let rows = independent_rows(system, &geometry, &yardstick);
    Ok(judge(system, rows, (&phi, &scale), residual, [q, q]))
}

/// The verdict on the pose q, reached from `guess`.
fn judge<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
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
    let worst = worst_rows(S::MODEL, displacements.as_slice(), scale.tolerance);
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
        worst_rows: worst.iter().map(|&(i, name)| (name, phi[i])).collect(),
        changes: Vec::new(),
    }
}

/// The holonomic rows that are farthest from satisfied, the worst first. (Not generic: compiled once.)
fn worst_rows(model: &Model, displacements: &[f64], tolerance: f64) -> Vec<(usize, &'static str)> {
    let displacements = displacements.iter().copied().zip(model.rows);
    let mut worst: Vec<_> = displacements
        .enumerate()
        .take(model.structure.holonomic_rows)
        .collect();
    worst.sort_by(|a, b| b.1.0.total_cmp(&a.1.0));
    worst.retain(|(_, (displacement, _))| *displacement > tolerance);
    worst.truncate(8);
    worst.iter().map(|(i, (_, row))| (*i, row.name)).collect()
}

/// The names of these rows.
fn names(model: &Model, rows: &[usize]) -> Vec<&'static str> {
    rows.iter()
        .filter_map(|&i| Some(model.rows.get(i)?.name))
        .collect()
}

/// The rows that do not depend on others. A row that is zero except for round-off is dependent.
pub(crate) fn independent_rows<
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    _: &S,
    geometry: &ConstraintGeometry<S, Q, N, R>,
    yardstick: &Yardstick<Q, N>,
) -> Dependence {
    dependence(geometry.a.rows(), geometry.w.rows(), |i| {
        vanishes(geometry, yardstick, i)
    })
}

/// Whether a row is zero except for round-off.
pub(crate) fn vanishes<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    geometry: &ConstraintGeometry<S, Q, N, R>,
    yardstick: &Yardstick<Q, N>,
    row: usize,
) -> bool {
    let expected = RowScale::<R>::expected::<S, Q, N>(row, yardstick.length);
    yardstick.row_length_squared(&geometry.a[row]) <= (NOTHING * expected).powi(2)
}

/// Newton's method from the guess, or where it does not close the rows, after they have been closed little by little.
fn close<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
    q: &mut SVector<f64, Q>,
    phi: &mut SVector<f64, R>,
    scale: &RowScale<R>,
) -> Result<(), Fault> {
    let guess = *q;
    newton(system, geometry, q, phi, scale)?;
    if residual_of(phi, &scale.weights) <= 1.0 {
        return Ok(());
    }
    let mut moved = guess;
    let arrives = continuation::follow(system, geometry, &mut moved, scale)?;
    if arrives {
        *q = moved;
    }
    geometry.evaluate(system, 0.0, q, phi)?;
    match arrives {
        true => newton(system, geometry, q, phi, scale),
        false => Ok(()),
    }
}

/// Damped Newton in the metric of M: q ← q ⊕ −M⁻¹Aᵀ(A M⁻¹ Aᵀ)⁻¹φ, with the proximal solve where rows are dependent.
fn newton<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
    q: &mut SVector<f64, Q>,
    phi: &mut SVector<f64, R>,
    scale: &RowScale<R>,
) -> Result<(), Fault> {
    let mut solver = Box::new(DelassusFactor::new());
    for _ in 0..MAX_ITERATIONS {
        let before = residual_of(phi, &scale.weights);
        if before <= 1.0 {
            return Ok(());
        }
        solver.factor(&holonomic_delassus(geometry));
        let mut multiplier = negative(phi);
        solver.solve(&mut multiplier);
        let mut factor = 1.0;
        loop {
            let mut way = SVector::zeros();
            accumulate(&mut way, &geometry.w, &multiplier);
            let trial = system.advance(q, &way, factor);
            let mut residual = SVector::zeros();
            system.holonomic(0.0, &trial, &mut residual);
            if residual_of(&residual, &scale.weights) < before {
                *q = trial;
                break;
            }
            factor *= 0.5;
            if factor < 1e-6 {
                // No step reduces the residual: it is round-off, or the rows contradict each other.
                return Ok(());
            }
        }
        geometry.evaluate(system, 0.0, q, phi)?;
    }
    Ok(())
}

/// S of the holonomic rows, with unit rows in place of the others.
fn holonomic_delassus<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    geometry: &ConstraintGeometry<S, Q, N, R>,
) -> RowMatrix<R, R> {
    let mut delassus = geometry.delassus.clone();
    let rows = delassus.entries_mut();
    for i in S::STRUCTURE.holonomic_rows..R {
        for j in 0..R {
            rows[i][j] = 0.0;
            rows[j][i] = 0.0;
        }
        rows[i][i] = 1.0;
    }
    delassus
}

/// v ← v − M⁻¹Aᵀ(A M⁻¹ Aᵀ)⁻¹(A v + b): the nearest velocity that satisfies the rows.
fn project<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    geometry: &ConstraintGeometry<S, Q, N, R>,
    v: &mut SVector<f64, N>,
    scale: &RowScale<R>,
    speed: f64,
) {
    let mut solver = Box::new(DelassusFactor::new());
    solver.factor(&geometry.delassus);
    for _ in 0..3 {
        let rates = geometry.velocity_rows(system, v);
        // Velocities that satisfy the rows are left as they are.
        if residual_of(&rates, &scale.weights) <= scale.round_off(speed) {
            return;
        }
        let mut multiplier = negative(&rates);
        solver.solve(&mut multiplier);
        accumulate(v, &geometry.w, &multiplier);
    }
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
    let mut v = *declared;
    start.velocities(geometry, q, &mut v)?;
    let violation = |v| scale.displacement(&geometry.velocity_rows(system, v));
    let prescribed = scale.displacement(&geometry.b).max(start.fastest(q, &v));
    let speed = speed.max(yardstick.measure(&v)).max(prescribed);
    let open = start.open(Level::Velocity, q, &v, speed);
    let possible = violation(free).max(ASSEMBLED * speed);
    match open.is_empty() && violation(&v) <= possible {
        true => Ok(Ok(v)),
        false => Ok(Err(open)),
    }
}

/// q with unit quaternions; refused where one is zero.
fn unit_rotations<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
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
fn check_guess(named: &[Coordinate], values: &[f64]) -> Result<(), SimulationError> {
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
