//! The start of a large mechanism, and other rows during a run, without dense arrays, where nothing is held: the same as with them.

mod factors;

use self::factors::Factors;
use super::guess::check_start;
use super::newton::{ASSEMBLED, MAX_ITERATIONS, is_closed, unwind};
use super::verdict::{judge, moved};
use crate::alf3f::residual_of;
use crate::contract::{constraint_rows, mass_rows};
use crate::large::{check_dense_start, is_large, is_sparse, starts_sparse};
use crate::linear::sparse::{Entries, Recorder, dependence};
use crate::linear::{Dependence, finite, largest, zeros};
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{AssemblyVerdict, Settings, SimulationError, System};
use nalgebra::SVector;

/// Positions, velocities and the verdict on them.
pub(super) type Assembled<const Q: usize, const N: usize> =
    (SVector<f64, Q>, SVector<f64, N>, AssemblyVerdict);

/// What satisfies the rows at the time t, or what is wrong with it; `None` where dense arrays are needed, and for what does not
/// assemble, on which they have more to say.
pub(super) fn assemble<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    settings: &Settings,
    (t, guess, declared): (f64, &SVector<f64, Q>, &SVector<f64, N>),
    yardstick: &Yardstick<Q, N>,
    scale: &RowScale<R>,
) -> Option<Result<Assembled<Q, N>, SimulationError>> {
    let mut start = SparseStart::new(system, settings, (t, guess))?;
    let (mut q, mut v) = (*guess, *declared);
    let before = largest(&start.phi);
    if !start.close(&mut q, scale)? {
        if check_dense_start(N, R).is_ok() || !finite(&q) {
            return None;
        }
        let rows = rows(system, t, &q, yardstick)?;
        let verdict = judge(system, rows, (&start.phi, scale), before, [guess, &q]);
        return Some(Err(SimulationError::Assembly(verdict)));
    }
    if is_closed(&start.phi, scale) && unwind(system, t, guess, &mut q, scale) {
        start.evaluate(&q);
    }
    if !start.project(&mut v, scale, yardstick) {
        return None;
    }
    let rates = (&start.rates(&v), &start.b);
    match check_start(system, (t, &q, &v), rates, (scale, yardstick), settings) {
        Ok(()) => {}
        // Dense arrays may come nearer to velocities that satisfy the rows.
        Err(SimulationError::Contradiction { .. }) if check_dense_start(N, R).is_ok() => {
            return None;
        }
        Err(error) => return Some(Err(error)),
    }
    let rows = rows(system, t, &q, yardstick)?;
    let mut verdict = judge(system, rows, (&start.phi, scale), before, [guess, &q]);
    verdict.changes = moved::<S, Q, N, R>([guess, &q], [declared, &v], yardstick.length);
    Some(Ok((q, v, verdict)))
}

/// The rows that depend on others at a pose; `None` if M is not positive definite.
pub(super) fn rows<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    q: &SVector<f64, Q>,
    yardstick: &Yardstick<Q, N>,
) -> Option<Dependence> {
    let a = constraint_rows(system, t, q);
    dependence(&a, &mass_rows(system, q), &|i| {
        RowScale::<R>::vanishes::<S, Q, N>(yardstick, i, a.row(i))
    })
}

/// Whether a mechanism may have factors for such a start: a constant, so that others do not compile the code for it.
pub(super) const fn is_possible<
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>() -> bool {
    is_planned::<S, Q, N, R>() || is_large::<N, R>()
}

/// Whether a mechanism has factors for such a start.
pub(super) fn applies<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    settings: &Settings,
) -> bool {
    is_planned::<S, Q, N, R>() || is_sparse::<S, Q, N, R>(settings)
}

const fn is_planned<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>() -> bool {
    starts_sparse::<N, R>()
        && S::STRUCTURE.constant_mass
        && S::STRUCTURE.holonomic_rows == R
        && S::ELIMINATION.is_some()
}

/// M and A at a pose, and their factors.
struct SparseStart<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    system: &'a S,
    time: f64,
    mass: Entries,
    a: Entries,
    phi: SVector<f64, R>,
    b: SVector<f64, R>,
    factors: Factors<N, R>,
}

impl<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    SparseStart<'a, S, Q, N, R>
{
    /// At the time t and the pose q; `None` if the pattern is singular.
    fn new(system: &'a S, settings: &Settings, (t, q): (f64, &SVector<f64, Q>)) -> Option<Self> {
        let (mut mass, mut a) = (Recorder::default(), Recorder::default());
        let (mut phi, mut b) = (zeros(), zeros());
        system.mass_matrix(q, &mut mass);
        system.constraints(t, q, &mut phi, &mut a, &mut b);
        let (mass, a) = (Entries::of(mass), Entries::of(a));
        let factors = match S::ELIMINATION {
            Some(plan) if is_planned::<S, Q, N, R>() && !is_sparse::<S, Q, N, R>(settings) => {
                Factors::planned(plan, &mass_rows(system, q))
            }
            _ => Factors::new(&mass, &a)?,
        };
        let mut start = SparseStart {
            system,
            time: t,
            mass,
            a,
            phi,
            b,
            factors,
        };
        start.evaluate(q);
        Some(start)
    }

    fn evaluate(&mut self, q: &SVector<f64, Q>) {
        let SparseStart {
            system,
            time,
            mass,
            a,
            phi,
            b,
            factors,
        } = self;
        system.mass_matrix(q, &mut mass.sink());
        system.constraints(*time, q, phi, &mut a.sink(), b);
        if let Some(k) = factors.planned_entries() {
            system.sparse_constraints(*time, q, phi, k, b);
        }
    }

    /// Factors the matrix with the first `rows` rows; false where the solution needs dense arrays.
    fn factor(&mut self, rows: usize) -> bool {
        self.factors.factor((&self.mass, &self.a), rows)
    }

    /// Damped Newton in the metric of M, as with dense arrays; false if it does not close the rows, `None` where the solution needs
    /// dense arrays.
    fn close(&mut self, q: &mut SVector<f64, Q>, scale: &RowScale<R>) -> Option<bool> {
        let holonomic = S::STRUCTURE.holonomic_rows;
        for _ in 0..MAX_ITERATIONS {
            if is_closed(&self.phi, scale) {
                return Some(true);
            }
            let before = residual_of(&self.phi, &scale.weights);
            let phi = self.phi;
            let change = |i: usize| if i < holonomic { -phi[i] } else { 0.0 };
            let way = match self.factor(holonomic) {
                true => self.factors.way(change),
                false => None,
            };
            let way = way?;
            let mut factor = 1.0;
            *q = loop {
                let trial = self.system.advance(q, &way, factor);
                let mut residual = zeros();
                self.system.holonomic(self.time, &trial, &mut residual);
                if residual_of(&residual, &scale.weights) < before {
                    break trial;
                }
                factor *= 0.5;
                if factor < 1e-6 {
                    return Some(scale.displacement(&self.phi) <= ASSEMBLED);
                }
            };
            self.evaluate(q);
        }
        Some(scale.displacement(&self.phi) <= ASSEMBLED)
    }

    /// A v + b.
    fn rates(&self, v: &SVector<f64, N>) -> SVector<f64, R> {
        let mut rates = self.b;
        for (row, column, value) in self.a.iter() {
            rates[row] += value * v[column];
        }
        rates
    }

    /// v ← the nearest velocity that satisfies the rows; false without a solution. Velocities that satisfy them are left
    /// as they are.
    fn project(
        &mut self,
        v: &mut SVector<f64, N>,
        scale: &RowScale<R>,
        yardstick: &Yardstick<Q, N>,
    ) -> bool {
        let speed = yardstick.measure(v);
        for pass in 0..3 {
            let rates = self.rates(v);
            if residual_of(&rates, &scale.weights) <= scale.round_off(speed) {
                return true;
            }
            if pass == 0 && !self.factor(R) {
                return false;
            }
            match self.factors.way(|i| -rates[i]) {
                Some(way) => *v += way,
                None => return false,
            }
        }
        true
    }
}
