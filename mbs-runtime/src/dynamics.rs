//! The equations of motion at one state, as matrices.

#[cfg(feature = "std")]
mod reactions;

use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::free::free;
use crate::linear::{DelassusFactor, RowMatrix, accumulate, dot, finite, vector};
use crate::memory::Box;
use crate::singular::Thresholds;
use crate::{Model, SimulationError, System, TensorSink};
use core::fmt;
use nalgebra::{SMatrix, SVector};

/// M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0 at a state of a mechanism, evaluated; made by
/// [`Simulation::dynamics`](crate::Simulation::dynamics).
///
/// [`Dynamics::evaluate`] evaluates it at any other state and allocates nothing:
///
/// ```
/// # use mbs_runtime::{Simulation, mechanism};
/// mechanism!(Pendulum {
///     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
///     rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
///     pivot: Revolute(ground.origin, rod.a),
/// });
///
/// # fn main() -> Result<(), Box<dyn core::error::Error>> {
/// let simulation: PendulumSimulation = Simulation::new(Pendulum {})?;
/// let mut dynamics = simulation.dynamics()?;
/// let at_rest = dynamics.accelerations()[0];
/// let (q, v) = (*simulation.positions(), [2.0].into());
/// dynamics.evaluate(0.0, &q, &v)?;
/// assert!((dynamics.mass_matrix()[(0, 0)] - 1.0 / 3.0).abs() < 1e-15);
/// assert_eq!(dynamics.accelerations()[0], at_rest);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Dynamics<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) system: S,
    /// Of the parameters of the simulation that has made it.
    pub(crate) revision: u32,
    pub(crate) geometry: Box<ConstraintGeometry<S, Q, N, R>>,
    pub(crate) solver: Box<DelassusFactor<R>>,
    time: f64,
    positions: SVector<f64, Q>,
    velocities: SVector<f64, N>,
    mass: RowMatrix<N, N>,
    jacobian_rate: RowMatrix<N, R>,
    residuals: SVector<f64, R>,
    convective: SVector<f64, R>,
    forces: SVector<f64, N>,
    accelerations: SVector<f64, N>,
    multipliers: SVector<f64, R>,
    /// Of all joints; a list of any length.
    #[cfg(feature = "std")]
    reactions: Vec<f64>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Dynamics<S, Q, N, R> {
    /// The equations of a system at time t and a configuration q with velocities v.
    ///
    /// # Errors
    /// As [`Dynamics::evaluate`].
    pub fn new(
        system: S,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<Self, SimulationError> {
        Self::of(system, t, q, v).map_err(|fault| told::<S, Q, N, R>(fault, t))
    }

    pub(crate) fn of(
        system: S,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<Self, Fault> {
        let mut dynamics = Dynamics {
            geometry: ConstraintGeometry::new(&system, q)?,
            system,
            revision: 0,
            solver: Box::new(solver_for(S::MODEL)),
            time: t,
            positions: *q,
            velocities: *v,
            mass: RowMatrix::zeros(),
            jacobian_rate: RowMatrix::zeros(),
            residuals: SVector::zeros(),
            convective: SVector::zeros(),
            forces: SVector::zeros(),
            accelerations: SVector::zeros(),
            multipliers: SVector::zeros(),
            #[cfg(feature = "std")]
            reactions: vec![0.0; S::MODEL.reactions.len()],
        };
        dynamics.solve(t, q, v)?;
        Ok(dynamics)
    }

    /// Evaluates all quantities at another state, which need not satisfy the constraints. Inputs are those of the
    /// simulation from which this was made.
    ///
    /// Where rows follow from others, a state that violates them makes these independent, and multipliers, then accelerations, become
    /// wrong: for a beam on three cranks of a metre a violation of 0.1 mm changes multipliers by a fifth, and one of 1 mm
    /// accelerations by a sixth. To close loops at measured positions, hold these at the start of a simulation
    /// ([`Simulation::start`](crate::Simulation::start)).
    ///
    /// # Errors
    /// A mass matrix that is not positive definite, or rows that admit no finite multiplier. The previous values are
    /// lost then.
    pub fn evaluate(
        &mut self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<(), SimulationError> {
        self.solve(t, q, v)
            .map_err(|fault| told::<S, Q, N, R>(fault, t))
    }

    /// With F = f + ∂T/∂q the first equation reads M v̇ = F − (∂p/∂q) v + Aᵀλ, which needs no affinities.
    fn solve(&mut self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> Result<(), Fault> {
        let (system, geometry) = (&self.system, &mut self.geometry);
        (self.time, self.positions, self.velocities) = (t, *q, *v);
        geometry.mass = system.factor_mass(q).ok_or(Fault::Mass)?;
        geometry.evaluate(system, t, q, &mut self.residuals)?;
        system.mass_matrix(q, self.mass.entries_mut());
        system.constraint_rates(
            t,
            q,
            v,
            self.jacobian_rate.entries_mut(),
            &mut self.convective,
        );
        system.applied_forces(t, q, v, &mut self.forces);
        self.accelerations = free(system, &geometry.mass, t, q, v);
        self.multipliers = SVector::zeros();
        self.solver.factor(&geometry.delassus);
        // The second pass is a correction if the proximal solve was needed; otherwise it is round-off.
        for _ in 0..2 {
            let mut change: SVector<f64, R> =
                vector(|i| -self.convective[i] - dot(&geometry.a[i], &self.accelerations));
            self.solver.solve(&mut change);
            accumulate(&mut self.accelerations, &geometry.w, &change);
            self.multipliers += change;
        }
        match finite(&self.accelerations) && finite(&self.multipliers) {
            true => Ok(()),
            false => Err(Fault::NonFinite("reactions")),
        }
    }

    /// M; entry (i, j) is an energy, J, over the units of velocities i and j of [`Model::velocities`](crate::Model::velocities):
    /// kg, kg m or kg m².
    pub fn mass_matrix(&self) -> &SMatrix<f64, N, N> {
        &self.mass
    }

    /// Aᵀ: column i is row i of the constraint Jacobian, its unit per second over that of each velocity.
    pub fn constraint_jacobian(&self) -> &SMatrix<f64, N, R> {
        &self.geometry.a
    }

    /// Ȧᵀ: column i is the rate of row i along v, 1/s times the units of A.
    pub fn constraint_jacobian_rate(&self) -> &SMatrix<f64, N, R> {
        &self.jacobian_rate
    }

    /// φ of the holonomic rows, in their units; zero for the others.
    pub fn residuals(&self) -> &SVector<f64, R> {
        &self.residuals
    }

    /// b of the velocity rows A v + b; m/s or rad/s for rows in m or rad.
    pub fn rheonomic_terms(&self) -> &SVector<f64, R> {
        &self.geometry.b
    }

    /// γ of the acceleration rows A v̇ + γ; m/s² or rad/s² for rows in m or rad.
    pub fn convective_terms(&self) -> &SVector<f64, R> {
        &self.convective
    }

    /// f, the applied generalized forces, N or N m.
    pub fn applied_forces(&self) -> &SVector<f64, N> {
        &self.forces
    }

    /// Writes Γ, with the structure constants of rotations ([`Inertia::affinities`](crate::Inertia::affinities), which
    /// allocates if they are not generated). An array `[SMatrix<f64, N, N>; N]` receives Γ_ijk as `gamma[i][(j, k)]`.
    pub fn affinities(&self, gamma: &mut impl TensorSink) {
        self.system.affinities(&self.positions, gamma);
    }

    /// v̇, in the units of the velocities per second.
    pub fn accelerations(&self) -> &SVector<f64, N> {
        &self.accelerations
    }

    /// λ; N or N m for rows in m or rad. For rows that follow from others this is one solution of many.
    pub fn multipliers(&self) -> &SVector<f64, R> {
        &self.multipliers
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> fmt::Debug
    for Dynamics<S, Q, N, R>
{
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Dynamics")
            .field("mechanism", &S::MODEL.name)
            .field("time", &self.time)
            .field("positions", &self.positions.as_slice())
            .field("velocities", &self.velocities.as_slice())
            .field("accelerations", &self.accelerations.as_slice())
            .field("multipliers", &self.multipliers.as_slice())
            .finish_non_exhaustive()
    }
}

fn told<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    fault: Fault,
    t: f64,
) -> SimulationError {
    SimulationError::from_fault(fault, S::MODEL, t, 0.0)
}

/// Independent rows have small pivots where masses differ by many powers of ten, and beside singular poses; they are eliminated
/// as long as they have one. Of rows that follow from others only round-off is left, which is larger at poses that violate them.
fn solver_for<const R: usize>(model: &Model) -> DelassusFactor<R> {
    let mut solver = DelassusFactor::new();
    if model.has_independent_rows() {
        solver.thresholds = Thresholds::ELIMINATED;
    }
    solver
}
