//! Numbers of the figures that summaries do not have: single rows, the step and the penalties of Algorithm 1, and the
//! force that a step has applied.

use mbs_runtime::nalgebra::{Cholesky, DMatrix, DVector, SMatrix, SVector};
use mbs_runtime::{AnySimulation, Simulation, System};

/// Added to the diagonal, for rows of unit length: it distinguishes redundant rows from round-off.
const PROXIMAL: f64 = 1e-10;
/// Corrections that remove its influence where rows are independent.
const REFINEMENTS: usize = 3;

/// A simulation with access to its rows. Arrays of rows are in the order of [`Model::rows`](mbs_runtime::Model::rows).
pub trait Probe: AnySimulation {
    /// φ of the rows, and ψ̇ = A v + b.
    fn rows(&self) -> [Vec<f64>; 2];
    /// m̄ of equation (18).
    fn effective_masses(&self) -> Vec<f64>;
    /// The shortest step within the last nominal one, s, and the penalties at its end: of Algorithm 1 alone, zero elsewhere.
    fn algorithm(&self) -> (f64, Vec<f64>);
    /// The instant for [`Probe::mean_reactions`].
    fn instant(&self) -> Instant;
    /// The mean reactions between an earlier instant and this one, from the change of momentum, for every method. N and
    /// N m, in the order of [`Model::reactions`](mbs_runtime::Model::reactions); with redundant rows, those of least
    /// norm. Their error is of second order in the time between the instants.
    fn mean_reactions(&self, before: &Instant) -> Vec<f64>;
    /// The reactions that the method applied in its last step, which began at or after an earlier instant, from
    /// [`Simulation::step_multipliers`]; `None` for methods without multipliers of their own.
    fn own_reactions(&self, before: &Instant) -> Option<Vec<f64>>;
}

/// The state of a simulation.
#[derive(Debug, Clone, PartialEq)]
pub struct Instant {
    time: f64,
    q: Vec<f64>,
    v: Vec<f64>,
    /// p = M v.
    momentum: Vec<f64>,
    /// F of ṗ = F + Aᵀλ.
    force: Vec<f64>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Probe
    for Simulation<S, Q, N, R>
{
    fn rows(&self) -> [Vec<f64>; 2] {
        let (mut phi, mut a, mut b) = (SVector::zeros(), zeros::<R, N>(), SVector::zeros());
        let state = self.state();
        self.system()
            .constraints(state.time, &state.positions, &mut phi, &mut a, &mut b);
        let rates = *a * state.velocities + b;
        [list(&phi), list(&rates)]
    }

    fn effective_masses(&self) -> Vec<f64> {
        let state = self.state();
        match geometry(self.system(), state.time, &state.positions) {
            Some((_, delassus)) => list(&delassus.diagonal().map(f64::recip)),
            None => vec![f64::NAN; R],
        }
    }

    fn algorithm(&self) -> (f64, Vec<f64>) {
        let fields = &self.state().fields;
        (fields.shortest, list(&fields.penalty))
    }

    fn instant(&self) -> Instant {
        let state = self.state();
        let (t, q, v) = (state.time, &state.positions, &state.velocities);
        let (mut momentum, mut force) = (SVector::zeros(), SVector::zeros());
        self.system().momentum(q, v, &mut momentum);
        self.system().forces(t, q, v, &mut force);
        Instant {
            time: t,
            q: list(q),
            v: list(v),
            momentum: list(&momentum),
            force: list(&force),
        }
    }

    fn mean_reactions(&self, before: &Instant) -> Vec<f64> {
        let now = self.instant();
        let h = now.time - before.time;
        let system = self.system();
        let vector = |x: &[f64]| SVector::<f64, N>::from_column_slice(x);
        let mean = |a: &[f64], b: &[f64]| 0.5 * (vector(a) + vector(b));
        let rate = |a: &[f64], b: &[f64]| (vector(b) - vector(a)) / h;
        let v = mean(&before.v, &now.v);
        let start = SVector::from_column_slice(&before.q);
        let (t, q) = (before.time + 0.5 * h, system.advance(&start, &v, 0.5 * h));
        let unknown = || vec![f64::NAN; S::MODEL.reactions.len()];
        let (Some((a, delassus)), Some(mass)) = (geometry(system, t, &q), system.factor_mass(&q))
        else {
            return unknown();
        };
        let mut rest = rate(&before.momentum, &now.momentum) - mean(&before.force, &now.force);
        let acceleration = rate(&before.v, &now.v);
        system.solve_mass(&mass, &mut rest);
        let wanted = list(&a.tr_mul(&rest));
        let lambda = least(
            DMatrix::from_column_slice(R, R, delassus.as_slice()),
            DVector::from_vec(wanted),
        );
        let lambda = SVector::from_column_slice(lambda.as_slice());
        let mut reactions = unknown();
        system.reactions(t, &q, &v, &acceleration, &lambda, &mut reactions);
        reactions
    }

    fn own_reactions(&self, before: &Instant) -> Option<Vec<f64>> {
        let lambda = self.step_multipliers()?;
        let now = self.instant();
        let h = now.time - before.time;
        let [v0, v1] = [&before.v, &now.v].map(|v| SVector::<f64, N>::from_column_slice(v));
        let v = 0.5 * (v0 + v1);
        let start = SVector::from_column_slice(&before.q);
        let acceleration = (v1 - v0) / h;
        let (t, q) = (
            before.time + 0.5 * h,
            self.system().advance(&start, &v, 0.5 * h),
        );
        let mut reactions = vec![0.0; S::MODEL.reactions.len()];
        self.system()
            .reactions(t, &q, &v, &acceleration, &lambda, &mut reactions);
        Some(reactions)
    }
}

fn list<const K: usize>(x: &SVector<f64, K>) -> Vec<f64> {
    x.as_slice().to_vec()
}

fn zeros<const ROWS: usize, const COLUMNS: usize>() -> Box<SMatrix<f64, ROWS, COLUMNS>> {
    Box::new(SMatrix::zeros())
}

/// Aᵀ and A M⁻¹Aᵀ; `None` where M has no factor.
fn geometry<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    q: &SVector<f64, Q>,
) -> Option<(Box<SMatrix<f64, N, R>>, Box<SMatrix<f64, R, R>>)> {
    let (mut a, mut w, mut delassus) = (zeros::<R, N>(), zeros(), zeros());
    let mut ignored = SVector::zeros();
    system.constraints(t, q, &mut SVector::zeros(), &mut a, &mut ignored);
    let rows = Box::new(a.transpose());
    system.solve_mass_rows(&system.factor_mass(q)?, &rows, &mut w);
    system.delassus(&rows, &w, &mut delassus);
    Some((rows, delassus))
}

/// The least x, in rows of unit length, with `delassus` x = `wanted`.
fn least(delassus: DMatrix<f64>, wanted: DVector<f64>) -> DVector<f64> {
    let scale = delassus.diagonal().map(|square| square.sqrt().recip());
    let lengths = DMatrix::from_diagonal(&scale);
    let unit = &lengths * delassus * &lengths;
    let wanted = scale.component_mul(&wanted);
    let mut x = DVector::zeros(wanted.len());
    let identity = DMatrix::identity(wanted.len(), wanted.len());
    // Round-off of a matrix of less than full rank is no larger than what is added.
    let Some(factor) = Cholesky::new(&unit + PROXIMAL * identity) else {
        return x.map(|_: f64| f64::NAN);
    };
    for _ in 0..REFINEMENTS {
        x += factor.solve(&(&wanted - &unit * &x));
    }
    scale.component_mul(&x)
}
