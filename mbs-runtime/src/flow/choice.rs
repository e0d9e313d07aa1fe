//! The choice of the flow.

#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::fault::Fault;
use crate::large::{is_beside_others, is_sparse, may_be_sparse};
use crate::linear::{RowMatrix, dot, vector};
use crate::yardstick::Yardstick;
use crate::{Flow, Settings, SimulationError, State, Structure, System};
#[cfg(feature = "std")]
use crate::{contract::force_slopes, large::starts_sparse};
use nalgebra::SVector;

/// h²λ of M⁻¹(−∂f/∂q) above which the explicit flow is not used: its limit of stability is 4, but the energy error
/// is large below that already.
const STIFF: f64 = 0.25;
const POWER_ITERATIONS: usize = 30;

/// The flow of the settings, if the structure of the equations allows it; by default the flow that fits the
/// structure.
pub(crate) fn choose<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
    settings: &Settings,
) -> Result<Flow, SimulationError> {
    let natural = natural(&S::STRUCTURE);
    match settings.flow {
        Some(Flow::Leapfrog) if !S::STRUCTURE.constant_mass => Err(refuse(
            Flow::Leapfrog,
            "the mass matrix depends on the positions",
            natural,
        )),
        Some(Flow::Leapfrog) if S::STRUCTURE.velocity_forces => Err(refuse(
            Flow::Leapfrog,
            "forces depend on velocities",
            natural,
        )),
        Some(flow @ (Flow::Trapezoid | Flow::Midpoint)) if S::STRUCTURE.velocity_forces => {
            Err(refuse(
                flow,
                "forces depend on velocities, and kicks beside dampers lose accuracy",
                natural,
            ))
        }
        Some(flow) => Ok(flow),
        // Other flows have dense arrays.
        None if is_sparse::<S, Q, N, R>(settings) => Ok(Flow::Implicit),
        None if const { S::STRUCTURE.allows(Flow::Leapfrog) && S::STRUCTURE.position_forces } => {
            let stiffness = stiffness(system, state, settings.step).map_err(|fault| {
                SimulationError::from_fault(fault, S::MODEL, state.time, settings.step)
            })?;
            let stiff = settings.step * settings.step * stiffness > STIFF;
            Ok(match stiff {
                false => Flow::Leapfrog,
                true if is_beside_others::<N, R>() && may_be_sparse::<N, R>(settings) => {
                    Flow::Implicit
                }
                true => Flow::Trapezoid,
            })
        }
        None => Ok(natural),
    }
}

impl Structure {
    /// Whether such a mechanism can have this flow. Where the answer is a constant of the mechanism, the others are not
    /// compiled for it.
    pub(crate) const fn allows(&self, flow: Flow) -> bool {
        match flow {
            Flow::Leapfrog => self.constant_mass && !self.velocity_forces,
            Flow::Midpoint | Flow::Trapezoid => !self.velocity_forces,
            Flow::Implicit => true,
        }
    }
}

fn natural(structure: &Structure) -> Flow {
    if structure.velocity_forces {
        Flow::Implicit
    } else if structure.constant_mass {
        Flow::Leapfrog
    } else {
        Flow::Midpoint
    }
}

fn refuse(flow: Flow, because: &'static str, instead: Flow) -> SimulationError {
    SimulationError::Flow {
        flow,
        because,
        instead,
    }
}

/// The largest eigenvalue of M⁻¹(−∂f/∂q) in size, 1/s², by power iteration.
fn stiffness<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    state: &State<Q, N, R>,
    step: f64,
) -> Result<f64, Fault> {
    let yardstick = Yardstick::new(system, step);
    let (q, v) = (&state.positions, &state.velocities);
    let mass = system.factor_mass(q).ok_or(Fault::Mass)?;
    let solve = |x: &mut SVector<f64, N>| system.solve_mass(&mass, x);
    #[cfg(feature = "std")]
    if const { starts_sparse::<N, R>() } {
        let f_q = force_slopes(system, state.time, (q, v));
        let row = |i, x: &SVector<f64, N>| f_q.row(i).map(|(j, slope)| slope * x[j]).sum::<f64>();
        return Ok(largest_eigenvalue(&yardstick, row, solve));
    }
    let mut f_q = RowMatrix::<N, N>::zeros();
    let mut f_v = RowMatrix::<N, N>::zeros();
    system.applied_force_tangents(state.time, q, v, &mut f_q, &mut f_v);
    let row = |i, x: &SVector<f64, N>| dot(&f_q[i], x);
    Ok(largest_eigenvalue(&yardstick, row, solve))
}

/// The same from the products of the rows of ∂f/∂q, and x ← M⁻¹x.
fn largest_eigenvalue<const Q: usize, const N: usize>(
    yardstick: &Yardstick<Q, N>,
    row: impl Fn(usize, &SVector<f64, N>) -> f64,
    solve: impl Fn(&mut SVector<f64, N>),
) -> f64 {
    // A start without symmetry, so that it has a part of every eigenvector.
    let parts = vector(|i| 1.0 + 0.3 * ((i * i) as f64).sin());
    let mut x = yardstick.displacement(parts);
    let mut eigenvalue = 0.0;
    for _ in 0..POWER_ITERATIONS {
        let size = yardstick.measure(&x);
        if !(size > 0.0 && size.is_finite()) {
            break;
        }
        x = vector(|i| x[i] / size);
        let mut next: SVector<f64, N> = vector(|i| -row(i, &x));
        solve(&mut next);
        eigenvalue = yardstick.measure(&next);
        x = next;
    }
    eigenvalue
}
