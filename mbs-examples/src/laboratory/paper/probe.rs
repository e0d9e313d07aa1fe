//! Numbers of the figures that summaries do not have: single rows, the step and the penalties of Algorithm 1, and the
//! force that a step has applied.

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
        let (mut phi, mut a, mut b) = ([0.0; R], Box::new([[0.0; N]; R]), [0.0; R]);
        let state = self.state();
        self.system()
            .constraints(state.time, &state.positions, &mut phi, &mut a, &mut b);
        let rate = |i: usize| dot(&a[i], &state.velocities) + b[i];
        [phi.to_vec(), (0..R).map(rate).collect()]
    }

    fn effective_masses(&self) -> Vec<f64> {
        let state = self.state();
        let Some((_, _, delassus)) = geometry(self.system(), state.time, &state.positions) else {
            return vec![f64::NAN; R];
        };
        (0..R).map(|i| 1.0 / delassus[i][i]).collect()
    }

    fn algorithm(&self) -> (f64, Vec<f64>) {
        let fields = &self.state().fields;
        (fields.shortest, fields.penalty.to_vec())
    }

    fn instant(&self) -> Instant {
        let state = self.state();
        let (t, q, v) = (state.time, &state.positions, &state.velocities);
        let (mut momentum, mut force) = ([0.0; N], [0.0; N]);
        self.system().momentum(q, v, &mut momentum);
        self.system().forces(t, q, v, &mut force);
        Instant {
            time: t,
            q: q.to_vec(),
            v: v.to_vec(),
            momentum: momentum.to_vec(),
            force: force.to_vec(),
        }
    }

    fn mean_reactions(&self, before: &Instant) -> Vec<f64> {
        let now = self.instant();
        let h = now.time - before.time;
        let system = self.system();
        let mean = |a: &[f64], b: &[f64]| std::array::from_fn(|i| 0.5 * (a[i] + b[i]));
        let v: [f64; N] = mean(&before.v, &now.v);
        let start: [f64; Q] = std::array::from_fn(|i| before.q[i]);
        let (t, q) = (before.time + 0.5 * h, system.advance(&start, &v, 0.5 * h));
        let unknown = || vec![f64::NAN; S::MODEL.reactions.len()];
        let (Some((a, w, delassus)), Some(mass)) =
            (geometry(system, t, &q), system.factor_mass(&q))
        else {
            return unknown();
        };
        let force: [f64; N] = mean(&before.force, &now.force);
        let mut rest: [f64; N] =
            std::array::from_fn(|i| (now.momentum[i] - before.momentum[i]) / h - force[i]);
        let acceleration: [f64; N] = std::array::from_fn(|i| (now.v[i] - before.v[i]) / h);
        system.solve_mass(&mass, &mut rest);
        let wanted: Vec<f64> = a.iter().map(|row| dot(row, &rest)).collect();
        drop(w);
        let delassus: Vec<Vec<f64>> = delassus.iter().map(|row| row.to_vec()).collect();
        let lambda = least(delassus, &wanted);
        let lambda: [f64; R] = std::array::from_fn(|i| lambda[i]);
        let mut reactions = unknown();
        system.reactions(t, &q, &v, &acceleration, &lambda, &mut reactions);
        reactions
    }

    fn own_reactions(&self, before: &Instant) -> Option<Vec<f64>> {
        let lambda = self.step_multipliers()?;
        let now = self.instant();
        let h = now.time - before.time;
        let v: [f64; N] = std::array::from_fn(|i| 0.5 * (before.v[i] + now.v[i]));
        let start: [f64; Q] = std::array::from_fn(|i| before.q[i]);
        let acceleration: [f64; N] = std::array::from_fn(|i| (now.v[i] - before.v[i]) / h);
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

type Rows<const R: usize, const N: usize> = Box<[[f64; N]; R]>;

/// A, M⁻¹Aᵀ and A M⁻¹Aᵀ; `None` where M has no factor.
fn geometry<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    q: &[f64; Q],
) -> Option<(Rows<R, N>, Rows<R, N>, Rows<R, R>)> {
    let (mut a, mut w) = (Box::new([[0.0; N]; R]), Box::new([[0.0; N]; R]));
    let mut delassus = Box::new([[0.0; R]; R]);
    system.constraints(t, q, &mut [0.0; R], &mut a, &mut [0.0; R]);
    system.solve_mass_rows(&system.factor_mass(q)?, &a, &mut w);
    system.delassus(&a, &w, &mut delassus);
    Some((a, w, delassus))
}

/// The least x, in rows of unit length, with `delassus` x = `wanted`.
fn least(mut delassus: Vec<Vec<f64>>, wanted: &[f64]) -> Vec<f64> {
    let count = wanted.len();
    let scale: Vec<f64> = (0..count).map(|i| delassus[i][i].sqrt().recip()).collect();
    for i in 0..count {
        for j in 0..count {
            delassus[i][j] *= scale[i] * scale[j];
        }
    }
    let factor = cholesky(&delassus);
    let mut x = vec![0.0; count];
    for _ in 0..REFINEMENTS {
        let left: Vec<f64> = (0..count)
            .map(|i| scale[i] * wanted[i] - dot(&delassus[i], &x))
            .collect();
        for (x, change) in x.iter_mut().zip(solve(&factor, left)) {
            *x += change;
        }
    }
    x.iter().zip(&scale).map(|(x, scale)| x * scale).collect()
}

/// L of a matrix with [`PROXIMAL`] added to its diagonal.
fn cholesky(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let count = matrix.len();
    let mut l = vec![vec![0.0; count]; count];
    for i in 0..count {
        for j in 0..=i {
            let rest = matrix[i][j] - dot(&l[i][..j], &l[j][..j]);
            l[i][j] = if i == j {
                (rest + PROXIMAL).max(PROXIMAL).sqrt()
            } else {
                rest / l[j][j]
            };
        }
    }
    l
}

fn solve(l: &[Vec<f64>], mut x: Vec<f64>) -> Vec<f64> {
    let count = l.len();
    for i in 0..count {
        x[i] = (x[i] - dot(&l[i][..i], &x[..i])) / l[i][i];
    }
    for i in (0..count).rev() {
        let above: f64 = (i + 1..count).map(|j| l[j][i] * x[j]).sum();
        x[i] = (x[i] - above) / l[i][i];
    }
    x
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
