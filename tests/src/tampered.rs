//! A system in which one function is slightly wrong, or one sign is flipped. The tests have to find each such error.

use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{
    Configuration, Constraints, Inertia, Loads, MatrixSink, Model, Observables, ScalarState,
    Structure, System, TensorSink,
};

/// The functions that can be made wrong, by the argument or value that they give.
pub const QUANTITIES: &[&str] = &[
    "mass",
    "p",
    "affinities",
    "holonomic",
    "phi",
    "a",
    "b",
    "a_rate",
    "gamma",
    "f",
    "F",
    "free_forces",
    "f_q",
    "f_v",
    "F_q",
    "F_v",
    "p_q",
    "acceleration",
    "T",
    "V",
    "power",
    "difference",
    "free_flight",
    "solve_mass",
    "solve_mass_rows",
    "delassus",
    "metric_rows",
    "metric_delassus",
    "row_rates",
    "accelerations",
    "multipliers",
];

/// Relative size of the error.
const ERROR: f64 = 1e-4;

/// What is wrong with a quantity.
#[derive(Debug, Clone, Copy)]
enum Fault {
    /// A small relative error, in the largest component of a vector or in every entry of a matrix.
    Size,
    /// The sign of one entry.
    Sign([usize; 3]),
}

impl Fault {
    fn value(self, place: [usize; 3], value: f64) -> f64 {
        match self {
            Fault::Size => value + ERROR * value.abs().max(1.0),
            Fault::Sign(wrong) if wrong == place => -value,
            Fault::Sign(_) => value,
        }
    }
}

/// `inner`, with an error in `wrong`.
#[derive(Debug, Clone)]
pub struct Tampered<S> {
    inner: S,
    wrong: &'static str,
    fault: Fault,
}

impl<S> Tampered<S> {
    /// Makes one quantity wrong.
    pub fn new(inner: S, wrong: &'static str) -> Self {
        Tampered {
            inner,
            wrong,
            fault: Fault::Size,
        }
    }

    /// Flips the sign of one entry of a quantity.
    pub fn with_sign_flipped(inner: S, wrong: &'static str, entry: [usize; 3]) -> Self {
        Tampered {
            inner,
            wrong,
            fault: Fault::Sign(entry),
        }
    }

    fn fault(&self, quantity: &str) -> Option<Fault> {
        (quantity == self.wrong).then_some(self.fault)
    }

    fn number(&self, quantity: &str, value: f64) -> f64 {
        match self.fault(quantity) {
            Some(fault) => fault.value([0; 3], value),
            None => value,
        }
    }

    fn vector(&self, quantity: &str, values: &mut [f64]) {
        let Some(fault) = self.fault(quantity) else {
            return;
        };
        let mut entries = values.iter_mut().enumerate();
        let entry = match fault {
            Fault::Size => entries.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs())),
            Fault::Sign([entry, ..]) => entries.nth(entry),
        };
        if let Some((i, value)) = entry {
            *value = fault.value([i, 0, 0], *value);
        }
    }

    fn sink<'a, T>(&self, quantity: &str, sink: &'a mut T) -> Wrong<'a, T> {
        let fault = self.fault(quantity);
        Wrong { sink, fault }
    }
}

/// Changes entries while they are written.
struct Wrong<'a, T> {
    sink: &'a mut T,
    fault: Option<Fault>,
}

impl<T> Wrong<'_, T> {
    fn value(&self, place: [usize; 3], value: f64) -> f64 {
        match self.fault {
            Some(fault) => fault.value(place, value),
            None => value,
        }
    }
}

impl<T: MatrixSink> MatrixSink for Wrong<'_, T> {
    fn set(&mut self, row: usize, column: usize, value: f64) {
        let wrong = self.value([row, column, 0], value);
        // One triangle more than the other, so that M is not symmetric: otherwise it would be the right M of another
        // mechanism.
        let more = match self.fault {
            Some(Fault::Size) if row > column => 1.5,
            _ => 1.0,
        };
        self.sink.set(row, column, value + more * (wrong - value));
    }
}

impl<T: TensorSink> TensorSink for Wrong<'_, T> {
    fn set(&mut self, i: usize, j: usize, k: usize, value: f64) {
        let value = self.value([i, j, k], value);
        self.sink.set(i, j, k, value);
    }
}

impl<S: Configuration<Q, N>, const Q: usize, const N: usize> Configuration<Q, N> for Tampered<S> {
    const ROTATIONS: &'static [usize] = S::ROTATIONS;

    fn guess(&self) -> (SVector<f64, Q>, SVector<f64, N>) {
        self.inner.guess()
    }
    fn advance(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, h: f64) -> SVector<f64, Q> {
        self.inner.advance(q, v, h)
    }
    fn difference(&self, from: &SVector<f64, Q>, to: &SVector<f64, Q>) -> SVector<f64, N> {
        let mut way = self.inner.difference(from, to);
        self.vector("difference", way.as_mut_slice());
        way
    }
    fn free_flight(&self, q: &mut SVector<f64, Q>, v: &mut SVector<f64, N>, h: f64) {
        self.inner.free_flight(q, v, h);
        self.vector("free_flight", v.as_mut_slice());
    }
}

impl<S: Inertia<Q, N>, const Q: usize, const N: usize> Inertia<Q, N> for Tampered<S> {
    type Mass = S::Mass;

    fn mass_matrix(&self, q: &SVector<f64, Q>, mass: &mut impl MatrixSink) {
        self.inner.mass_matrix(q, &mut self.sink("mass", mass));
    }
    fn factor_mass(&self, q: &SVector<f64, Q>) -> Option<Self::Mass> {
        self.inner.factor_mass(q)
    }
    fn solve_mass(&self, mass: &Self::Mass, x: &mut SVector<f64, N>) {
        self.inner.solve_mass(mass, x);
        self.vector("solve_mass", x.as_mut_slice());
    }
    fn momentum(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, p: &mut SVector<f64, N>) {
        self.inner.momentum(q, v, p);
        self.vector("p", p.as_mut_slice());
    }
    fn affinities(&self, q: &SVector<f64, Q>, gamma: &mut impl TensorSink) {
        self.inner
            .affinities(q, &mut self.sink("affinities", gamma));
    }
    fn kinetic_energy(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        self.number("T", self.inner.kinetic_energy(q, v))
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Constraints<Q, N, R>
    for Tampered<S>
{
    fn holonomic(&self, t: f64, q: &SVector<f64, Q>, phi: &mut SVector<f64, R>) {
        self.inner.holonomic(t, q, phi);
        self.vector(
            "holonomic",
            &mut phi.as_mut_slice()[..S::STRUCTURE.holonomic_rows],
        );
    }
    fn constraints(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        phi: &mut SVector<f64, R>,
        a: &mut impl MatrixSink,
        b: &mut SVector<f64, R>,
    ) {
        self.inner.constraints(t, q, phi, &mut self.sink("a", a), b);
        self.vector(
            "phi",
            &mut phi.as_mut_slice()[..S::STRUCTURE.holonomic_rows],
        );
        // Differences do not know b of a nonholonomic row by itself.
        let rows = match self.fault {
            Fault::Size => S::STRUCTURE.holonomic_rows,
            Fault::Sign(_) => R,
        };
        self.vector("b", &mut b.as_mut_slice()[..rows]);
    }
    fn constraint_rates(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        a_rate: &mut impl MatrixSink,
        gamma: &mut SVector<f64, R>,
    ) {
        self.inner
            .constraint_rates(t, q, v, &mut self.sink("a_rate", a_rate), gamma);
        self.vector("gamma", gamma.as_mut_slice());
    }
    fn solve_mass_rows(
        &self,
        mass: &Self::Mass,
        a: &SMatrix<f64, N, R>,
        w: &mut SMatrix<f64, N, R>,
    ) {
        self.inner.solve_mass_rows(mass, a, w);
        self.vector("solve_mass_rows", w.as_mut_slice());
    }
    fn delassus(
        &self,
        a: &SMatrix<f64, N, R>,
        w: &SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    ) {
        self.inner.delassus(a, w, delassus);
        self.vector("delassus", delassus.as_mut_slice());
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
        self.inner.metric(mass, t, q, a, w, delassus);
        self.vector("metric_rows", w.as_mut_slice());
        self.vector("metric_delassus", delassus.as_mut_slice());
    }
    fn row_rates(&self, a: &SMatrix<f64, N, R>, v: &SVector<f64, N>, rates: &mut SVector<f64, R>) {
        self.inner.row_rates(a, v, rates);
        self.vector("row_rates", rates.as_mut_slice());
    }
}

impl<S: Loads<Q, N>, const Q: usize, const N: usize> Loads<Q, N> for Tampered<S> {
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
        self.inner.applied_forces(t, q, v, f);
        self.vector("f", f.as_mut_slice());
    }
    fn forces(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f: &mut SVector<f64, N>) {
        self.inner.forces(t, q, v, f);
        self.vector("F", f.as_mut_slice());
    }
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    ) {
        let (mut f_q, mut f_v) = (self.sink("f_q", f_q), self.sink("f_v", f_v));
        self.inner
            .applied_force_tangents(t, q, v, &mut f_q, &mut f_v);
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
        let (mut f_q, mut f_v) = (self.sink("F_q", f_q), self.sink("F_v", f_v));
        self.inner
            .force_tangents(t, q, v, &mut f_q, &mut f_v, &mut self.sink("p_q", p_q));
    }
    fn free_forces(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f: &mut SVector<f64, N>,
    ) {
        self.inner.free_forces(t, q, v, f);
        self.vector("free_forces", f.as_mut_slice());
    }
    fn acceleration(&self, t: f64, q: &SVector<f64, Q>, acceleration: &mut SVector<f64, N>) {
        self.inner.acceleration(t, q, acceleration);
        self.vector("acceleration", acceleration.as_mut_slice());
    }
    fn potential_energy(&self, q: &SVector<f64, Q>) -> f64 {
        let energy = self.inner.potential_energy(q);
        // A constant error would have no effect.
        if self.wrong == "V" {
            energy * (1.0 + ERROR) + ERROR * q[0]
        } else {
            energy
        }
    }
    fn nonconservative_power(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        self.number("power", self.inner.nonconservative_power(t, q, v))
    }
}

impl<S: Observables<Q, N, R>, const Q: usize, const N: usize, const R: usize> Observables<Q, N, R>
    for Tampered<S>
{
    type Outputs = S::Outputs;
    const STATES: &'static [ScalarState] = S::STATES;

    fn states(&self) -> &[ScalarState] {
        self.inner.states()
    }

    fn outputs(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, outputs: &mut [f64]) {
        self.inner.outputs(t, q, v, outputs);
    }
    fn events(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, events: &mut [f64]) {
        self.inner.events(t, q, v, events);
    }
    fn points(&self, t: f64, q: &SVector<f64, Q>, points: &mut [[f64; 3]]) {
        self.inner.points(t, q, points);
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
        self.inner
            .reactions(t, q, v, acceleration, lambda, reactions);
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> System<Q, N, R>
    for Tampered<S>
{
    const MODEL: &'static Model = S::MODEL;
    const STRUCTURE: Structure = S::STRUCTURE;

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
        let generated =
            (self.inner).accelerations(t, q, v, correction, acceleration, lambda, inverse_pivot);
        self.vector("accelerations", acceleration.as_mut_slice());
        self.vector("multipliers", lambda.as_mut_slice());
        generated
    }
}
