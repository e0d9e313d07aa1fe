//! Stage 4: system → derived quantities.
//!
//! | quantity | symbol | from |
//! |---|---|---|
//! | constraint Jacobian | A | ∂φ/∂q, ∂ψ̇/∂v |
//! | rheonomic part | b | ∂φ/∂t, ψ̇ at v = 0 |
//! | rates | Ȧ, γ | d/dt along v |
//! | affinities | Γ_ijk | ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i), and the structure constants of rotations |
//! | tangents | ∂F/∂q, ∂F/∂v, ∂p/∂q | F = f + ∂T/∂q (+ p × ω for rotations), p = M v |
//!
//! Derivatives by q are taken along the velocities: for rotations along the angular velocities in body axes.
//!
//! AFTER THIS STAGE: every entry that is structurally zero is absent.

mod affinities;
mod constraints;
mod curvature;
mod matrix;
mod tangents;

use crate::equations::{InverseMass, System};
use crate::symbolic::{Expr, Graph, Symbol};
use curvature::Curvature;

pub use affinities::Affinities;
pub(crate) use constraints::{RowDerivatives, derive as rows, holonomic};
pub use matrix::Matrix;
use tangents::Inertial;
pub use tangents::Tangents;

/// All that is computed from the system.
#[derive(Debug)]
pub struct Derived {
    /// The system.
    pub system: System,
    /// Whether M does not depend on q.
    pub constant_mass: bool,
    /// p = M v.
    pub momentum: Vec<Expr>,
    /// T = ½ v·M v, without states.
    pub kinetic: Expr,
    /// Affinities of the first kind, (i, j, k). `None` if they are long: no integrator needs them, because ∂T/∂q and
    /// ∂p/∂q are equivalent; the runtime computes them from ∂p/∂q.
    pub affinities: Option<Affinities>,
    /// Constraint Jacobian A.
    pub jacobian: Matrix,
    /// b of φ̇ = A v + b.
    pub rheonomic: Vec<Expr>,
    /// Ȧ.
    pub jacobian_rate: Matrix,
    /// γ of A v̇ + γ = 0.
    pub convective: Vec<Expr>,
    /// F = f + ∂T/∂q, and p × ω for rotations.
    pub total_forces: Vec<Expr>,
    /// F − ṗ|_v, with the rate of p at constant v: M v̇ without rows.
    pub free_forces: Vec<Expr>,
    /// p × ω of rotations.
    pub turning: Vec<Expr>,
    /// ∂f/∂q and ∂f/∂v.
    pub applied: Tangents,
    /// ∂F/∂q and ∂F/∂v.
    pub total: Tangents,
    /// ∂p/∂q.
    pub momentum_by_position: Matrix,
    /// M⁻¹ f, where M is constant and forces do not depend on velocities; `None`, too, where M⁻¹ has many entries: if
    /// they are needed at all, the functions that need them derive them.
    pub acceleration: Option<Vec<Expr>>,
    /// Whether forces depend on velocities. (By `sign` or `step` they may do so where ∂f/∂v = 0.)
    pub velocity_forces: bool,
    /// Rows that follow from others at generic poses: mobility finds them.
    pub redundant: Vec<usize>,
}

impl Derived {
    /// Whether M is constant and forces do not depend on velocities.
    pub fn is_explicit(&self) -> bool {
        self.constant_mass && !self.velocity_forces
    }
}

/// With more entries of M⁻¹, M⁻¹ f is not derived: a chain of a thousand bars has a million, and is solved without M⁻¹.
const MOST_ENTRIES: usize = 10_000;

/// Derives everything, once. `redundant` are rows that follow from others.
pub fn derive(mut system: System, redundant: Vec<usize>) -> Derived {
    let graph = &mut system.graph;
    let is_velocity = |symbol| matches!(symbol, Symbol::Velocity(_));
    let velocity_forces = graph.any_depends_on(system.forces.iter().copied(), is_velocity);
    let size = system.size;
    let (momentum, kinetic) = match &system.kinetic {
        Some(kinetic) => (kinetic.momentum.clone(), kinetic.energy),
        None => {
            let momentum = affinities::momentum(graph, size, &system.mass);
            let moving = system.mass.iter();
            let moving = moving.filter(|((i, _), _)| !system.layout.states.contains(i));
            let moving: Matrix = moving.map(|(&place, &entry)| (place, entry)).collect();
            let kinetic = affinities::kinetic(graph, size, &moving);
            (momentum, kinetic)
        }
    };
    let affinities = affinities::affinities(graph, &system.layout.rotations, &system.mass);
    let slopes: Vec<Expr> = match &system.kinetic {
        Some(kinetic) => kinetic.slopes.clone(),
        None => (0..size as u32)
            .map(|j| graph.derivative(kinetic, Symbol::Coordinate(j)))
            .collect(),
    };
    let rotations = &system.layout.rotations;
    let turning = affinities::turning_momentum(graph, rotations, &momentum);
    let total_forces: Vec<Expr> = (0..size)
        .map(|i| {
            let inertial = graph.add(slopes[i], turning[i]);
            graph.add(system.forces[i], inertial)
        })
        .collect();
    let free_forces = free_forces(graph, &total_forces, &momentum, system.constant_mass);
    let rows = constraints::derive(graph, &system.rows);
    let curvature = Curvature::new(graph, kinetic, &momentum, &slopes, rotations, &system.mass);
    let applied = Tangents::of_parts(graph, &system.force_parts, rotations);
    let applied = applied.or_direct(graph, &system.forces, &Matrix::new());
    let inertial = Inertial {
        turning: &turning,
        curvature: &curvature,
    };
    let total = applied.with_inertial(graph, &inertial);
    let total = total.or_direct(graph, &total_forces, &curvature.momentum);
    let explicit = system.constant_mass && !velocity_forces;
    let inverse = explicit.then(|| InverseMass::new(size, &system.mass));
    let inverse = inverse.filter(|inverse| inverse.entries() <= MOST_ENTRIES);
    let acceleration = inverse.map(|inverse| inverse.apply(graph, &system.forces));
    Derived {
        constant_mass: system.constant_mass,
        velocity_forces,
        momentum,
        kinetic,
        affinities,
        jacobian: rows.jacobian,
        rheonomic: rows.rheonomic,
        jacobian_rate: rows.jacobian_rate,
        convective: rows.convective,
        total_forces,
        free_forces,
        turning,
        applied,
        total,
        momentum_by_position: curvature.momentum,
        acceleration,
        redundant,
        system,
    }
}

/// F − ṗ|_v. The rate is a derivative along v, which takes a few times the operations of p; as the product of ∂p/∂q and v it
/// takes more by the number of velocities.
fn free_forces(
    graph: &mut Graph,
    total_forces: &[Expr],
    momentum: &[Expr],
    constant_mass: bool,
) -> Vec<Expr> {
    if constant_mass {
        return total_forces.to_vec();
    }
    let rates = graph.rates_at_constant_velocity(momentum);
    let pairs = total_forces.iter().zip(rates);
    pairs.map(|(&force, rate)| graph.sub(force, rate)).collect()
}
