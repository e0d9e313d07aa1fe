//! What a guess or a state has to be before its rows are closed: finite, with unit quaternions.

#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::linear::{largest, zeros};
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{
    Coordinate, Foreseen, Method, Model, PosesAhead, Settings, SimulationError, State,
    StepController, System, ThreeFields,
};
use nalgebra::SVector;

/// Violation of a row, as a displacement relative to the size of the mechanism, with which a state can be resumed.
const RESUMABLE: f64 = 1e-6;
/// The same for methods that leave residuals, whose size depends on the step, on the forces and on their own settings. A motion with
/// larger ones is of no use.
const RESUMABLE_OPEN: f64 = 1e-2;

/// Violations of the positions of rows, and of their rates, with which this method can resume.
fn resumable(method: &Method) -> [f64; 2] {
    use Method::{Baumgarte, Bdf, GeneralizedAlpha, MAlf, Paper, Penalty};
    use Method::{Index3Projections, Projected, Radau, Rattle, TwoLevel};
    match method {
        Paper(_) | MAlf(_) | Penalty(_) | Baumgarte(_) | Bdf(_) => [RESUMABLE_OPEN; 2],
        // Of index 3: it solves positions.
        GeneralizedAlpha(_) => [RESUMABLE, RESUMABLE_OPEN],
        TwoLevel | Projected | Index3Projections(_) | Rattle | Radau => [RESUMABLE; 2],
    }
}

/// Refuses a state that is not finite, or whose quaternions have not unit length.
pub(super) fn check_state<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
) -> Result<(), SimulationError> {
    check_finite("time", &[state.time, state.clock])?;
    check_finite("a coordinate", state.positions.as_slice())?;
    check_finite("a velocity", state.velocities.as_slice())?;
    check_finite("a multiplier", state.multipliers.as_slice())?;
    check_finite(
        "a change of a multiplier",
        state.multiplier_changes.as_slice(),
    )?;
    for stage in state.stage_multipliers.iter().flatten() {
        check_finite("a multiplier of a stage", stage.as_slice())?;
    }
    let ledger = &state.ledger;
    let works = [ledger.nonconservative_work, ledger.drive_work];
    check_finite("a work", &works)?;
    check_finite("the energy at the start", ledger.initial.as_slice())?;
    if let Some(range) = ledger.range {
        let energies = [
            range.depth,
            range.least,
            range.works,
            range.doubts,
            range.exchanged,
        ];
        check_finite("an energy of the motion", &energies)?;
    }
    check_controller(&state.step_controller)?;
    check_fields(&state.fields)?;
    check_poses_ahead(&state.poses_ahead)?;
    #[cfg(feature = "sparse")]
    check_factors(state)?;
    let q = &state.positions;
    let unit = unit_rotations(system, q)?;
    for (given, unit) in q.iter().zip(unit.iter()) {
        if (given - unit).abs() > 1e-6 {
            return Err(not_unit(given / unit));
        }
    }
    Ok(())
}

fn check_controller(controller: &StepController) -> Result<(), SimulationError> {
    let StepController {
        step,
        allowed,
        speed,
        estimate_factor,
        caution,
        usual,
        ..
    } = *controller;
    let what = "the step controller";
    check_finite(
        what,
        &[step, allowed, speed, estimate_factor, caution, usual],
    )?;
    check_finite(what, controller.difficulty.as_slice())?;
    check_finite(what, controller.estimated_difficulty.as_slice())?;
    match [step, speed, estimate_factor, caution, usual]
        .into_iter()
        .find(|value| *value < 0.0)
    {
        Some(value) => Err(SimulationError::State { what, value }),
        None => Ok(()),
    }
}

/// What is ahead is finite, and its rate positive: it divides.
fn check_poses_ahead(poses: &PosesAhead) -> Result<(), SimulationError> {
    let what = "a pose ahead";
    let wrong = |values: &[f64], positive: &[f64]| {
        let not_finite = values
            .iter()
            .chain(positive)
            .find(|value| !value.is_finite());
        not_finite
            .or_else(|| positive.iter().find(|value| **value < 0.0))
            .copied()
    };
    let of_step = poses
        .last_step
        .and_then(|step| wrong(&[step.begin], &[step.length, step.least]));
    let of_pose = match poses.foreseen {
        Some(Foreseen::Singular(time)) => wrong(&[time], &[]),
        Some(Foreseen::Turn { rate: 0.0, .. }) => Some(0.0),
        Some(Foreseen::Turn { least, rate }) => wrong(&[], &[least, rate]),
        None => None,
    };
    match of_step.or(of_pose) {
        Some(value) => Err(SimulationError::State { what, value }),
        None => Ok(()),
    }
}

/// Where factors were made, and the differences that corrections begin with, are numbers.
#[cfg(feature = "sparse")]
fn check_factors<const Q: usize, const N: usize, const R: usize>(
    state: &State<Q, N, R>,
) -> Result<(), SimulationError> {
    if let Some(factors) = &state.factors {
        let what = "the origin of factors";
        check_finite(what, &[factors.time, factors.step])?;
        check_finite(what, factors.positions.as_slice())?;
        check_finite(what, factors.velocities.as_slice())?;
    }
    if let Some(kept) = &state.differences {
        check_finite("a difference of velocities", &[kept.step, kept.third])?;
        for difference in &kept.differences {
            check_finite("a difference of velocities", difference.as_slice())?;
        }
    }
    Ok(())
}

fn check_fields<const N: usize, const R: usize>(
    fields: &ThreeFields<N, R>,
) -> Result<(), SimulationError> {
    let (rows, momentum) = (&fields.constraint_momentum, &fields.momentum);
    let of_rows = [
        &fields.lambda,
        &fields.mu,
        rows,
        &fields.penalty,
        &fields.change,
    ];
    let steps = [fields.step, fields.shortest, fields.length];
    let all = of_rows.into_iter().map(|field| field.as_slice());
    all.chain([momentum.as_slice(), &steps])
        .try_for_each(|values| check_finite("a field of Algorithm 1", values))
}

/// Refuses residuals φ of a state that does not satisfy the rows.
pub(super) fn check_rows<const R: usize>(
    model: &Model,
    phi: &SVector<f64, R>,
    scale: &RowScale<R>,
    method: &Method,
) -> Result<(), SimulationError> {
    let [allowed, _] = resumable(method);
    let allowed = allowed.max(scale.tolerance);
    for (i, row) in model.rows.iter().enumerate() {
        // Rows that are not numbers are refused, too.
        if !(scale.displacement_of(i, phi[i]) <= allowed) {
            return Err(SimulationError::StateRow {
                row: row.name,
                residual: phi[i],
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
    let [_, part] = resumable(&settings.method);
    let allowed = allowed_rate(settings, speed, part);
    for (i, (row, rate)) in model.rows.iter().zip(rates.iter().copied()).enumerate() {
        if !(scale.displacement_of(i, rate) <= allowed) {
            return Err(SimulationError::StateRow {
                row: row.name,
                residual: rate,
            });
        }
    }
    Ok(())
}

/// The rate of a row, as a displacement a second, that a motion of this speed may have, where rows may be violated by a `part` of the
/// size of the mechanism.
fn allowed_rate(settings: &Settings, speed: f64, part: f64) -> f64 {
    // What moves a row by less than its tolerance in a step is allowed at rest, too.
    let least = settings.constraint_tolerance / settings.step;
    // Where rows touch each other, as in a flat parallelogram, one that is open by e has rates of √e.
    let part = part.max(settings.constraint_tolerance.sqrt());
    (part * speed).max(least)
}

/// Refuses a start whose velocities, the nearest ones, leave rates of the rows, or whose forces or energies are not finite.
pub(super) fn check_start<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    (t, q, v): (f64, &SVector<f64, Q>, &SVector<f64, N>),
    (rates, prescribed): (&SVector<f64, R>, &SVector<f64, R>),
    (scale, yardstick): (&RowScale<R>, &Yardstick<Q, N>),
    settings: &Settings,
) -> Result<(), SimulationError> {
    check_loads(system, (t, q, v))?;
    let speed = yardstick.measure(v).max(scale.displacement(prescribed));
    let allowed = allowed_rate(settings, speed, RESUMABLE);
    let off = |i: &usize| scale.displacement_of(*i, rates[*i]);
    let worst = (0..R).max_by(|i, j| off(i).total_cmp(&off(j)));
    match worst.filter(|i| !(off(i) <= allowed)) {
        Some(i) => Err(SimulationError::Contradiction {
            row: S::MODEL.rows.get(i).map_or("unnamed row", |row| row.name),
            rate: rates[i],
        }),
        None => Ok(()),
    }
}

/// Refuses a start whose forces or energies are not finite.
fn check_loads<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    (t, q, v): (f64, &SVector<f64, Q>, &SVector<f64, N>),
) -> Result<(), SimulationError> {
    let mut forces = zeros();
    system.applied_forces(t, q, v, &mut forces);
    let force = largest(&forces);
    for (what, value) in [
        ("a force", force),
        ("the potential energy", system.potential_energy(q)),
        ("the kinetic energy", system.kinetic_energy(q, v)),
    ] {
        if !value.is_finite() {
            return Err(SimulationError::Guess { what, value });
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
