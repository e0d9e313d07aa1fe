//! The start of a large mechanism with sparse factors: the same as that with dense arrays, where all rows are
//! independent and nothing is held.

use super::{ASSEMBLED, MAX_ITERATIONS, judge, moved};
use crate::alf3f::residual_of;
use crate::linear::sparse::{Entries, Recorder, Saddle};
use crate::linear::{Dependence, largest, vector, zeros};
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{AssemblyVerdict, State, System};
use nalgebra::SVector;

/// A random right-hand side is answered by multipliers larger than this, relative to those of a row by itself, where
/// rows depend on others.
const DEPENDENT: f64 = 1e7;

/// The state and the verdict; `None` where dense arrays are needed, and for what does not assemble, on which they have more
/// to say.
pub(super) fn assemble<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    guess: &SVector<f64, Q>,
    declared: &SVector<f64, N>,
    yardstick: &Yardstick<Q, N>,
    scale: &RowScale<R>,
) -> Option<(State<Q, N, R>, AssemblyVerdict)> {
    let mut start = SparseStart::new(system, 0.0, guess)?;
    let (mut q, mut v) = (*guess, *declared);
    let before = largest(&start.phi);
    if !(start.close(&mut q, scale)
        && start.project(&mut v, scale, yardstick)
        && start.is_independent())
    {
        return None;
    }
    let phi = (&start.phi, scale);
    let mut verdict = judge(system, all_rows::<R>(), phi, before, [guess, &q]);
    verdict.changes = moved::<S, Q, N, R>([guess, &q], [declared, &v], yardstick.length);
    Some((State::new(0.0, q, v), verdict))
}

/// The verdict that all rows are independent at a pose; `None` where they are not.
pub(super) fn rows<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    q: &SVector<f64, Q>,
) -> Option<Dependence> {
    let mut start = SparseStart::new(system, t, q)?;
    (start.factor(R) && start.is_independent()).then(all_rows::<R>)
}

fn all_rows<const R: usize>() -> Dependence {
    Dependence {
        rank: R,
        dependent: Vec::new(),
    }
}

/// M and A at a pose, and the matrix [M −Aᵀ; A εD].
struct SparseStart<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    system: &'a S,
    t: f64,
    mass: Entries,
    a: Entries,
    phi: SVector<f64, R>,
    b: SVector<f64, R>,
    saddle: Saddle,
    x: Vec<f64>,
}

impl<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    SparseStart<'a, S, Q, N, R>
{
    /// At time t and the pose q; `None` if the pattern is singular.
    fn new(system: &'a S, t: f64, q: &SVector<f64, Q>) -> Option<Self> {
        let (mut mass, mut a) = (Recorder::default(), Recorder::default());
        let (mut phi, mut b) = (zeros(), zeros());
        system.mass_matrix(q, &mut mass);
        system.constraints(t, q, &mut phi, &mut a, &mut b);
        let (mass, a) = (Entries::of(mass), Entries::of(a));
        let saddle = Saddle::new([N, R], &mass, &a, std::iter::empty())?;
        let mut start = SparseStart {
            system,
            t,
            mass,
            a,
            phi,
            b,
            saddle,
            x: vec![0.0; N + R],
        };
        start.evaluate(q);
        Some(start)
    }

    fn evaluate(&mut self, q: &SVector<f64, Q>) {
        let SparseStart {
            system,
            t,
            mass,
            a,
            phi,
            b,
            ..
        } = self;
        system.mass_matrix(q, &mut mass.sink());
        system.constraints(*t, q, phi, &mut a.sink(), b);
    }

    /// Factors the matrix with the first `rows` rows; the multipliers of the others are zero.
    fn factor(&mut self, rows: usize) -> bool {
        self.saddle.begin(&self.mass, &self.a);
        self.saddle.add_rows(&self.a, 0..rows);
        self.saddle.lu.factor()
    }

    /// The change of least kinetic energy that changes the rows by these values; `None` if it is not finite.
    fn way(&mut self, rows: impl Fn(usize) -> f64) -> Option<SVector<f64, N>> {
        let (velocities, multipliers) = self.x.split_at_mut(N);
        velocities.fill(0.0);
        for (i, x) in multipliers.iter_mut().enumerate() {
            *x = rows(i);
        }
        let solved = self.saddle.lu.solve(&mut self.x);
        solved.then(|| SVector::from_column_slice(&self.x[..N]))
    }

    /// Damped Newton in the metric of M, as with dense arrays; false if it does not close the rows.
    fn close(&mut self, q: &mut SVector<f64, Q>, scale: &RowScale<R>) -> bool {
        let holonomic = S::STRUCTURE.holonomic_rows;
        for _ in 0..MAX_ITERATIONS {
            let before = residual_of(&self.phi, &scale.weights);
            if before <= 1.0 {
                return true;
            }
            let phi = self.phi;
            let change = |i: usize| if i < holonomic { -phi[i] } else { 0.0 };
            let way = self.factor(holonomic).then(|| self.way(change)).flatten();
            let Some(way) = way else { return false };
            let mut factor = 1.0;
            *q = loop {
                let trial = self.system.advance(q, &way, factor);
                let mut residual = zeros();
                self.system.holonomic(self.t, &trial, &mut residual);
                if residual_of(&residual, &scale.weights) < before {
                    break trial;
                }
                factor *= 0.5;
                if factor < 1e-6 {
                    return scale.displacement(&self.phi) <= ASSEMBLED;
                }
            };
            self.evaluate(q);
        }
        scale.displacement(&self.phi) <= ASSEMBLED
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
        if !self.factor(R) {
            return false;
        }
        for _ in 0..3 {
            let mut rates = self.b;
            for (row, column, value) in self.a.iter() {
                rates[row] += value * v[column];
            }
            if residual_of(&rates, &scale.weights) <= scale.round_off(speed) {
                return true;
            }
            match self.way(|i| -rates[i]) {
                Some(way) => *v += way,
                None => return false,
            }
        }
        true
    }

    /// Whether all rows are independent; after [`Self::factor`] with all of them.
    ///
    /// Of (A M⁻¹Aᵀ + ε D) κ = D r the part along a combination of rows without force is r/ε, and a random r has a part along
    /// each of them.
    fn is_independent(&mut self) -> bool {
        let right: SVector<f64, R> = vector(|i| 1.0 + 0.5 * ((i * i + 1) as f64).sin());
        let lengths = self.saddle.lengths().to_vec();
        if self.way(|i| right[i] * lengths[i]).is_none() {
            return false;
        }
        let multipliers = &self.x[N..];
        multipliers.iter().all(|x| x.abs() < DEPENDENT)
    }
}
