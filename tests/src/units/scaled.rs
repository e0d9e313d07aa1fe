//! A mechanism in other units: every number that goes in or comes out is multiplied.

use super::Units;
use super::factors::{each, entries, over, times};
use super::sinks::Sink;
use mbs_runtime::generated::Elimination;
use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{
    Configuration, Constraints, Inertia, Loads, MatrixSink, Mechanism, Model, Observables,
    ParameterError, Structure, System, TensorSink, UnknownName,
};
use std::sync::OnceLock;

/// A mechanism in other units.
#[derive(Debug, Clone)]
pub struct InUnits<M> {
    mechanism: M,
    units: Units,
}

impl<M: Mechanism> InUnits<M> {
    /// With default parameters.
    pub fn new(units: Units) -> Self {
        InUnits {
            mechanism: M::default(),
            units,
        }
    }
}

impl<M: Mechanism> Default for InUnits<M> {
    fn default() -> Self {
        Self::new(Units::powers_of_four(0, 0, 0))
    }
}

impl<M: Mechanism> Mechanism for InUnits<M> {
    type System = Scaled<M::System>;
    const MODEL: &'static Model = M::MODEL;

    fn prepare(&self) -> Result<Self::System, ParameterError> {
        let inner = self.mechanism.prepare()?;
        Ok(Scaled::new(inner, M::MODEL, self.units))
    }
    fn parameter(&self, name: &str) -> Option<f64> {
        self.mechanism.parameter(name)
    }
    fn set_parameter(&mut self, name: &str, value: f64) -> Result<(), UnknownName> {
        self.mechanism.set_parameter(name, value)
    }
}

/// The prepared form.
#[derive(Debug, Clone)]
pub struct Scaled<S> {
    inner: S,
    length: f64,
    time: f64,
    energy: f64,
    /// Factors of coordinates, velocities and rows, of the latter as they are and their rates.
    q: Vec<f64>,
    v: Vec<f64>,
    row: Vec<f64>,
    rate: Vec<f64>,
    output: Vec<f64>,
    reaction: Vec<f64>,
    /// The slots of the entries of A in the array of K, and their factors.
    slots: OnceLock<Vec<(usize, f64)>>,
}

impl<S> Scaled<S> {
    fn new(inner: S, model: &Model, units: Units) -> Self {
        let row: Vec<f64> = model
            .rows
            .iter()
            .map(|row| units.factor(row.unit))
            .collect();
        let rates = row.iter().enumerate().map(|(i, row)| {
            let is_rate = i >= model.holonomic_rows();
            if is_rate { *row } else { row / units.time }
        });
        Scaled {
            inner,
            length: units.length,
            time: units.time,
            energy: units.energy(),
            q: (model.coordinates.iter())
                .map(|q| units.factor(q.unit))
                .collect(),
            v: (model.velocities.iter())
                .map(|v| units.factor(v.unit))
                .collect(),
            rate: rates.collect(),
            row,
            slots: OnceLock::new(),
            output: (model.outputs.iter())
                .map(|output| units.factor(output.unit))
                .collect(),
            reaction: (model.reactions.iter())
                .map(|reaction| units.factor(reaction.unit))
                .collect(),
        }
    }

    /// A generalized momentum; a force by the time is less.
    fn momentum_factor(&self, i: usize) -> f64 {
        self.energy / self.v[i]
    }

    fn force_factor(&self, i: usize) -> f64 {
        self.momentum_factor(i) / self.time
    }

    fn multiplier_factor(&self, row: usize) -> f64 {
        self.energy / self.time / self.rate[row]
    }

    fn weighted_factor(&self, i: usize, row: usize) -> f64 {
        self.rate[row] * self.v[i] / self.energy
    }

    fn delassus_factor(&self, row: usize, other: usize) -> f64 {
        self.rate[row] * self.rate[other] / self.energy
    }
}

impl<S: Configuration<Q, N>, const Q: usize, const N: usize> Configuration<Q, N> for Scaled<S> {
    const ROTATIONS: &'static [usize] = S::ROTATIONS;

    fn guess(&self) -> (SVector<f64, Q>, SVector<f64, N>) {
        let (q, v) = self.inner.guess();
        (times(&q, |i| self.q[i]), times(&v, |i| self.v[i]))
    }
    fn advance(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, h: f64) -> SVector<f64, Q> {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        times(&self.inner.advance(&q, &v, h / self.time), |i| self.q[i])
    }
    fn difference(&self, from: &SVector<f64, Q>, to: &SVector<f64, Q>) -> SVector<f64, N> {
        let [from, to] = [from, to].map(|q| over(q, |i| self.q[i]));
        times(&self.inner.difference(&from, &to), |i| {
            self.v[i] * self.time
        })
    }
    fn free_flight(&self, q: &mut SVector<f64, Q>, v: &mut SVector<f64, N>, h: f64) {
        (*q, *v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.inner.free_flight(q, v, h / self.time);
        (*q, *v) = (times(q, |i| self.q[i]), times(v, |i| self.v[i]));
    }
}

impl<S: Inertia<Q, N>, const Q: usize, const N: usize> Inertia<Q, N> for Scaled<S> {
    type Mass = S::Mass;

    fn mass_matrix(&self, q: &SVector<f64, Q>, mass: &mut impl MatrixSink) {
        let factor = |i: usize, j: usize| self.momentum_factor(i) / self.v[j];
        let mut sink = Sink { sink: mass, factor };
        self.inner.mass_matrix(&over(q, |i| self.q[i]), &mut sink);
    }
    fn factor_mass(&self, q: &SVector<f64, Q>) -> Option<Self::Mass> {
        self.inner.factor_mass(&over(q, |i| self.q[i]))
    }
    fn solve_mass(&self, mass: &Self::Mass, x: &mut SVector<f64, N>) {
        *x = over(x, |i| self.momentum_factor(i));
        self.inner.solve_mass(mass, x);
        *x = times(x, |i| self.v[i]);
    }
    fn momentum(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, p: &mut SVector<f64, N>) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.inner.momentum(&q, &v, p);
        *p = times(p, |i| self.momentum_factor(i));
    }
    fn affinities(&self, q: &SVector<f64, Q>, gamma: &mut impl TensorSink) {
        let factor = |i: usize, j: usize, k: usize| self.force_factor(i) / (self.v[j] * self.v[k]);
        let mut sink = Sink {
            sink: gamma,
            factor,
        };
        self.inner.affinities(&over(q, |i| self.q[i]), &mut sink);
    }
    fn kinetic_energy(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.energy * self.inner.kinetic_energy(&q, &v)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Constraints<Q, N, R>
    for Scaled<S>
{
    // It works on the entries of K, which are scaled where they are written.
    const ELIMINATION: Option<&'static Elimination<N, R>> = S::ELIMINATION;

    fn sparse_constraints(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        phi: &mut SVector<f64, R>,
        k: &mut [f64],
        b: &mut SVector<f64, R>,
    ) {
        let slots = self.slots.get_or_init(|| {
            let plan = S::ELIMINATION.expect("an array of K is that of an elimination");
            let factor = |row: usize, j: usize| self.rate[row] / self.v[j];
            let entries = entries(plan).into_iter();
            entries
                .map(|[slot, row, j]| (slot, factor(row, j)))
                .collect()
        });
        let q = over(q, |i| self.q[i]);
        self.inner.sparse_constraints(t / self.time, &q, phi, k, b);
        for &(slot, factor) in slots {
            k[slot] *= factor;
        }
        *phi = times(phi, |i| self.row[i]);
        *b = times(b, |i| self.rate[i]);
    }
    fn sparse_mass(&self, q: &SVector<f64, Q>, k: &mut [f64]) {
        let plan = S::ELIMINATION.expect("an array of K is that of an elimination");
        self.inner.sparse_mass(&over(q, |i| self.q[i]), k);
        for &(i, j, slot) in plan.mass {
            k[slot] *= self.momentum_factor(i) / self.v[j];
        }
    }
    fn holonomic(&self, t: f64, q: &SVector<f64, Q>, phi: &mut SVector<f64, R>) {
        self.inner
            .holonomic(t / self.time, &over(q, |i| self.q[i]), phi);
        *phi = times(phi, |i| self.row[i]);
    }
    fn constraints(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        phi: &mut SVector<f64, R>,
        a: &mut impl MatrixSink,
        b: &mut SVector<f64, R>,
    ) {
        let factor = |row: usize, j: usize| self.rate[row] / self.v[j];
        let mut sink = Sink { sink: a, factor };
        let q = over(q, |i| self.q[i]);
        self.inner.constraints(t / self.time, &q, phi, &mut sink, b);
        *phi = times(phi, |i| self.row[i]);
        *b = times(b, |i| self.rate[i]);
    }
    fn constraint_rates(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        a_rate: &mut impl MatrixSink,
        gamma: &mut SVector<f64, R>,
    ) {
        let factor = |row: usize, j: usize| self.rate[row] / self.v[j] / self.time;
        let mut sink = Sink {
            sink: a_rate,
            factor,
        };
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.inner
            .constraint_rates(t / self.time, &q, &v, &mut sink, gamma);
        *gamma = times(gamma, |i| self.rate[i] / self.time);
    }
    fn solve_mass_rows(
        &self,
        mass: &Self::Mass,
        a: &SMatrix<f64, N, R>,
        w: &mut SMatrix<f64, N, R>,
    ) {
        let a = each(a, |row, i| self.v[i] / self.rate[row]);
        self.inner.solve_mass_rows(mass, &a, w);
        *w = each(w, |row, i| self.weighted_factor(i, row));
    }
    fn delassus(
        &self,
        a: &SMatrix<f64, N, R>,
        w: &SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    ) {
        let a = each(a, |row, i| self.v[i] / self.rate[row]);
        let w = each(w, |row, i| 1.0 / self.weighted_factor(i, row));
        self.inner.delassus(&a, &w, delassus);
        *delassus = each(delassus, |i, j| self.delassus_factor(i, j));
    }
    fn metric(
        &self,
        mass: &Self::Mass,
        t: f64,
        q: &SVector<f64, Q>,
        a: &SMatrix<f64, N, R>,
        w: &mut SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    ) {
        let a = each(a, |row, i| self.v[i] / self.rate[row]);
        let q = over(q, |i| self.q[i]);
        self.inner.metric(mass, t / self.time, &q, &a, w, delassus);
        *w = each(w, |row, i| self.weighted_factor(i, row));
        *delassus = each(delassus, |i, j| self.delassus_factor(i, j));
    }
    fn row_rates(&self, a: &SMatrix<f64, N, R>, v: &SVector<f64, N>, rates: &mut SVector<f64, R>) {
        let a = each(a, |row, i| self.v[i] / self.rate[row]);
        self.inner.row_rates(&a, &over(v, |i| self.v[i]), rates);
        *rates = times(rates, |i| self.rate[i]);
    }
}

impl<S: Loads<Q, N>, const Q: usize, const N: usize> Loads<Q, N> for Scaled<S> {
    type Inputs = S::Inputs;

    fn inputs(&self) -> &[f64] {
        self.inner.inputs()
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        self.inner.inputs_mut()
    }
    fn applied_forces(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f: &mut SVector<f64, N>,
    ) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.inner.applied_forces(t / self.time, &q, &v, f);
        *f = times(f, |i| self.force_factor(i));
    }
    fn forces(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f: &mut SVector<f64, N>) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.inner.forces(t / self.time, &q, &v, f);
        *f = times(f, |i| self.force_factor(i));
    }
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    ) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        let mut f_q = Sink {
            sink: f_q,
            factor: |i: usize, j: usize| self.force_factor(i) / (self.v[j] * self.time),
        };
        let mut f_v = Sink {
            sink: f_v,
            factor: |i: usize, j: usize| self.force_factor(i) / self.v[j],
        };
        self.inner
            .applied_force_tangents(t / self.time, &q, &v, &mut f_q, &mut f_v);
    }
    fn force_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    ) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        let mut f_q = Sink {
            sink: f_q,
            factor: |i: usize, j: usize| self.force_factor(i) / (self.v[j] * self.time),
        };
        let mut f_v = Sink {
            sink: f_v,
            factor: |i: usize, j: usize| self.force_factor(i) / self.v[j],
        };
        let mut p_q = Sink {
            sink: p_q,
            factor: |i: usize, j: usize| self.momentum_factor(i) / (self.v[j] * self.time),
        };
        self.inner
            .force_tangents(t / self.time, &q, &v, &mut f_q, &mut f_v, &mut p_q);
    }
    fn acceleration(&self, t: f64, q: &SVector<f64, Q>, acceleration: &mut SVector<f64, N>) {
        let q = over(q, |i| self.q[i]);
        self.inner.acceleration(t / self.time, &q, acceleration);
        *acceleration = times(acceleration, |i| self.v[i] / self.time);
    }
    fn potential_energy(&self, q: &SVector<f64, Q>) -> f64 {
        self.energy * self.inner.potential_energy(&over(q, |i| self.q[i]))
    }
    fn nonconservative_power(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.energy / self.time * self.inner.nonconservative_power(t / self.time, &q, &v)
    }
}

impl<S: Observables<Q, N, R>, const Q: usize, const N: usize, const R: usize> Observables<Q, N, R>
    for Scaled<S>
{
    type Outputs = S::Outputs;

    fn outputs(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, outputs: &mut [f64]) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.inner.outputs(t / self.time, &q, &v, outputs);
        outputs
            .iter_mut()
            .zip(&self.output)
            .for_each(|(x, factor)| *x *= factor);
    }
    fn events(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, events: &mut [f64]) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        self.inner.events(t / self.time, &q, &v, events);
    }
    fn points(&self, t: f64, q: &SVector<f64, Q>, points: &mut [[f64; 3]]) {
        self.inner
            .points(t / self.time, &over(q, |i| self.q[i]), points);
        points
            .as_flattened_mut()
            .iter_mut()
            .for_each(|x| *x *= self.length);
    }
    fn reactions(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        acceleration: &SVector<f64, N>,
        lambda: &SVector<f64, R>,
        reactions: &mut [f64],
    ) {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        let acceleration = over(acceleration, |i| self.v[i] / self.time);
        let lambda = over(lambda, |i| self.multiplier_factor(i));
        self.inner
            .reactions(t / self.time, &q, &v, &acceleration, &lambda, reactions);
        reactions
            .iter_mut()
            .zip(&self.reaction)
            .for_each(|(x, factor)| *x *= factor);
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> System<Q, N, R>
    for Scaled<S>
{
    const MODEL: &'static Model = S::MODEL;
    const STRUCTURE: Structure = S::STRUCTURE;
    const PARTITIONED: bool = S::PARTITIONED;

    fn accelerations(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        correction: &SVector<f64, R>,
        acceleration: &mut SVector<f64, N>,
        lambda: &mut SVector<f64, R>,
        inverse_pivot: &mut SVector<f64, R>,
    ) -> bool {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        let correction = over(correction, |i| self.rate[i] / self.time);
        let generated = self.inner.accelerations(
            t / self.time,
            &q,
            &v,
            &correction,
            acceleration,
            lambda,
            inverse_pivot,
        );
        *acceleration = times(acceleration, |i| self.v[i] / self.time);
        *lambda = times(lambda, |i| self.multiplier_factor(i));
        // 0 and −1 are no pivots.
        *inverse_pivot = SVector::from_fn(|i, _| match inverse_pivot[i] > 0.0 {
            true => inverse_pivot[i] / self.delassus_factor(i, i),
            false => inverse_pivot[i],
        });
        generated
    }

    fn partitioned_accelerations(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        correction: &SVector<f64, R>,
        acceleration: &mut SVector<f64, N>,
        weakness: &mut SVector<f64, R>,
    ) -> bool {
        let (q, v) = (over(q, |i| self.q[i]), over(v, |i| self.v[i]));
        let correction = over(correction, |i| self.rate[i] / self.time);
        let t = t / self.time;
        let generated =
            (self.inner).partitioned_accelerations(t, &q, &v, &correction, acceleration, weakness);
        *acceleration = times(acceleration, |i| self.v[i] / self.time);
        generated
    }
}
