//! Hand-written mechanisms: what `mechanism!` would generate, as plainly as possible.
#![allow(dead_code)]

pub mod alloc;
pub mod bennett;
pub mod bricard;
pub mod planar;
pub mod scenes;
pub mod space;
pub mod spatial;

use mbs_runtime::generated::{Spin, entries, rotation_between, turned};
use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{
    Configuration, Constraints, Inertia, Loads, MatrixSink, Mechanism, Model, Observables,
    ParameterError, Row, RowKind, Structure, System, TensorSink, UnknownName, World,
};

/// The equations of a scene, in arrays; the rest is filled in by [`Hand`], tangents by central differences.
pub trait Scene<const Q: usize, const N: usize, const R: usize>:
    Clone + Default + Send + Sync + 'static
{
    const STRUCTURE: Structure;
    const ROWS: &'static [Row] = &[];
    /// Where the angular velocities begin in v; a unit quaternion stands in their place in q.
    const ROTATIONS: &'static [usize] = &[];
    const EVENTS: &'static [&'static str] = &[];
    fn guess(&self) -> ([f64; Q], [f64; N]);
    fn mass(&self, q: &[f64; Q]) -> [[f64; N]; N];
    fn force(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> [f64; N];
    /// ∂T/∂q.
    fn kinetic_gradient(&self, _q: &[f64; Q], _v: &[f64; N]) -> [f64; N] {
        [0.0; N]
    }
    /// One for each of [`Scene::ROTATIONS`].
    fn spins(&self) -> Vec<Spin> {
        Vec::new()
    }
    /// φ, A, b.
    fn rows(&self, t: f64, q: &[f64; Q]) -> ([f64; R], [[f64; N]; R], [f64; R]);
    fn potential(&self, q: &[f64; Q]) -> f64;
    fn power(&self, _t: f64, _q: &[f64; Q], _v: &[f64; N]) -> f64 {
        0.0
    }
    fn event(&self, _t: f64, _q: &[f64; Q], _v: &[f64; N]) -> f64 {
        0.0
    }
}

pub const fn structure(
    constant_mass: bool,
    velocity_forces: bool,
    holonomic_rows: usize,
) -> Structure {
    Structure {
        constant_mass,
        velocity_forces,
        position_forces: true,
        time_dependent: true,
        holonomic_rows,
        rotations: 0,
    }
}

pub const fn row(name: &'static str, kind: RowKind) -> Row {
    Row {
        name,
        entry: name,
        kind,
        unit: "m",
    }
}

/// A scene as a mechanism without parameters.
#[derive(Clone, Default)]
pub struct Parameters<T, const Q: usize, const N: usize, const R: usize>(pub T);

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Mechanism
    for Parameters<T, Q, N, R>
{
    type System = Hand<T, Q, N, R>;
    const MODEL: &'static Model = <Hand<T, Q, N, R> as System<Q, N, R>>::MODEL;
    fn prepare(&self) -> Result<Self::System, ParameterError> {
        Ok(Hand::new(self.0.clone()))
    }
    fn parameter(&self, _: &str) -> Option<f64> {
        None
    }
    fn set_parameter(&mut self, name: &str, _: f64) -> Result<(), UnknownName> {
        Err(UnknownName::new("parameter", name, []))
    }
}

#[derive(Clone)]
pub struct Hand<T, const Q: usize, const N: usize, const R: usize> {
    pub scene: T,
    inverse: SMatrix<f64, N, N>,
    spins: Vec<Spin>,
    inputs: [f64; 1],
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Hand<T, Q, N, R> {
    pub fn new(scene: T) -> Self {
        Hand {
            spins: scene.spins(),
            inverse: matrix(scene.mass(&scene.guess().0)).try_inverse().unwrap(),
            scene,
            inputs: [0.0],
        }
    }
    /// Calls `translation(i in q, j in v)` and `rotation(i, j, number)`.
    fn each(
        mut translation: impl FnMut(usize, usize),
        mut rotation: impl FnMut(usize, usize, usize),
    ) {
        let (mut i, mut j, mut number) = (0, 0, 0);
        while j < N {
            if T::ROTATIONS.contains(&j) {
                rotation(i, j, number);
                (i, j, number) = (i + 4, j + 3, number + 1);
            } else {
                translation(i, j);
                (i, j) = (i + 1, j + 1);
            }
        }
    }
    /// Column by column D_j f, by central differences along the velocities.
    fn along(
        &self,
        q: &SVector<f64, Q>,
        sink: &mut impl MatrixSink,
        f: impl Fn(&SVector<f64, Q>) -> SVector<f64, N>,
    ) {
        differences(&SVector::zeros(), sink, |way| f(&self.advance(q, way, 1.0)));
    }
    fn mass(&self, q: &SVector<f64, Q>) -> SMatrix<f64, N, N> {
        matrix(self.scene.mass(entries(q)))
    }
    fn force(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> SVector<f64, N> {
        self.scene.force(t, entries(q), entries(v)).into()
    }
    fn total(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> SVector<f64, N> {
        let gradient: SVector<f64, N> = self.scene.kinetic_gradient(entries(q), entries(v)).into();
        self.force(t, q, v) + gradient
    }
}

/// The largest difference of two entries.
pub fn distance<'a>(
    a: impl IntoIterator<Item = &'a f64>,
    b: impl IntoIterator<Item = &'a f64>,
) -> f64 {
    let pairs = a.into_iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

pub fn unit<const N: usize>(j: usize) -> SVector<f64, N> {
    SVector::from_fn(|i, _| if i == j { 1.0 } else { 0.0 })
}

/// From its rows.
pub fn matrix<const N: usize, const R: usize>(rows: [[f64; N]; R]) -> SMatrix<f64, R, N> {
    SMatrix::<f64, N, R>::from(rows).transpose()
}

fn part<const K: usize>(x: &[f64], i: usize) -> [f64; K] {
    std::array::from_fn(|k| x[i + k])
}

fn put<const N: usize, const R: usize>(matrix: &SMatrix<f64, R, N>, sink: &mut impl MatrixSink) {
    for i in 0..R {
        for j in 0..N {
            sink.set(i, j, matrix[(i, j)]);
        }
    }
}

/// Column by column ∂f/∂x by central differences, into a sink.
fn differences<const N: usize>(
    x: &SVector<f64, N>,
    sink: &mut impl MatrixSink,
    f: impl Fn(&SVector<f64, N>) -> SVector<f64, N>,
) {
    for j in 0..N {
        let e = 1e-6;
        let step = e * unit(j);
        let slope = (f(&(x + step)) - f(&(x - step))) / (2.0 * e);
        for i in 0..N {
            sink.set(i, j, slope[i]);
        }
    }
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Configuration<Q, N>
    for Hand<T, Q, N, R>
{
    const ROTATIONS: &'static [usize] = T::ROTATIONS;

    fn guess(&self) -> (SVector<f64, Q>, SVector<f64, N>) {
        let (q, v) = self.scene.guess();
        (q.into(), v.into())
    }
    fn advance(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, h: f64) -> SVector<f64, Q> {
        let next = std::cell::Cell::new(*q);
        let set = |i: usize, values: &[f64]| {
            let mut q = next.get();
            q.as_mut_slice()[i..i + values.len()].copy_from_slice(values);
            next.set(q);
        };
        let (q, v) = (entries(q), entries(v));
        Self::each(
            |i, j| set(i, &[q[i] + h * v[j]]),
            |i, j, _| set(i, &turned(part(q, i), part(v, j), h)),
        );
        next.get()
    }
    fn difference(&self, from: &SVector<f64, Q>, to: &SVector<f64, Q>) -> SVector<f64, N> {
        let way = std::cell::Cell::new(SVector::<f64, N>::zeros());
        let set = |j: usize, values: &[f64]| {
            let mut v = way.get();
            v.as_mut_slice()[j..j + values.len()].copy_from_slice(values);
            way.set(v);
        };
        let (from, to) = (entries(from), entries(to));
        Self::each(
            |i, j| set(j, &[to[i] - from[i]]),
            |i, j, _| set(j, &rotation_between(part(from, i), part(to, i))),
        );
        way.get()
    }
    fn free_flight(&self, q: &mut SVector<f64, Q>, v: &mut SVector<f64, N>, h: f64) {
        let mut next = self.advance(q, v, h);
        Self::each(
            |_, _| {},
            |i, j, number| {
                let (q, omega) = (part(entries(q), i), part(entries(v), j));
                let (turned, omega) = self.spins[number].flight(q, omega, h);
                next.as_mut_slice()[i..i + 4].copy_from_slice(&turned);
                v.as_mut_slice()[j..j + 3].copy_from_slice(&omega);
            },
        );
        *q = next;
    }
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Inertia<Q, N>
    for Hand<T, Q, N, R>
{
    type Mass = SMatrix<f64, N, N>;

    fn mass_matrix(&self, q: &SVector<f64, Q>, mass: &mut impl MatrixSink) {
        put(&self.mass(q), mass);
    }
    fn factor_mass(&self, q: &SVector<f64, Q>) -> Option<Self::Mass> {
        self.mass(q).try_inverse()
    }
    fn solve_mass(&self, mass: &Self::Mass, x: &mut SVector<f64, N>) {
        *x = mass * *x;
    }
    fn momentum(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, p: &mut SVector<f64, N>) {
        *p = self.mass(q) * v;
    }
    fn affinities(&self, q: &SVector<f64, Q>, gamma: &mut impl TensorSink) {
        let e = 1e-6;
        let slope: [SMatrix<f64, N, N>; N] = std::array::from_fn(|k| {
            let at = |e: f64| self.mass(&self.advance(q, &unit(k), e));
            (at(e) - at(-e)) / (2.0 * e)
        });
        for i in 0..N {
            for j in 0..N {
                for k in 0..N {
                    gamma.set(
                        i,
                        j,
                        k,
                        0.5 * (slope[k][(i, j)] + slope[j][(i, k)] - slope[i][(j, k)]),
                    );
                }
            }
        }
    }
    fn kinetic_energy(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        0.5 * v.dot(&(self.mass(q) * v))
    }
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Constraints<Q, N, R>
    for Hand<T, Q, N, R>
{
    fn holonomic(&self, t: f64, q: &SVector<f64, Q>, phi: &mut SVector<f64, R>) {
        *phi = self.scene.rows(t, entries(q)).0.into();
    }
    fn constraints(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        phi: &mut SVector<f64, R>,
        a: &mut impl MatrixSink,
        b: &mut SVector<f64, R>,
    ) {
        let rows = self.scene.rows(t, entries(q));
        *phi = rows.0.into();
        *b = rows.2.into();
        put(&matrix(rows.1), a);
    }
    fn constraint_rates(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        a_rate: &mut impl MatrixSink,
        gamma: &mut SVector<f64, R>,
    ) {
        let e = 1e-6;
        let at = |e: f64| {
            let (_, a, b) = self.scene.rows(t + e, entries(&self.advance(q, v, e)));
            (matrix(a), SVector::from(b))
        };
        let (up, down) = (at(e), at(-e));
        let rate = (up.0 - down.0) / (2.0 * e);
        put(&rate, a_rate);
        *gamma = (up.1 - down.1) / (2.0 * e) + rate * v;
    }
    fn solve_mass_rows(
        &self,
        mass: &Self::Mass,
        a: &SMatrix<f64, N, R>,
        w: &mut SMatrix<f64, N, R>,
    ) {
        mass.mul_to(a, w);
    }
    fn delassus(
        &self,
        a: &SMatrix<f64, N, R>,
        w: &SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    ) {
        w.tr_mul_to(a, delassus);
    }
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Loads<Q, N>
    for Hand<T, Q, N, R>
{
    type Inputs = ();

    fn inputs(&self) -> &[f64] {
        &self.inputs
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        &mut self.inputs
    }
    fn applied_forces(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f: &mut SVector<f64, N>,
    ) {
        *f = self.force(t, q, v);
    }
    fn forces(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f: &mut SVector<f64, N>) {
        *f = self.total(t, q, v);
    }
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    ) {
        self.along(q, f_q, |q| self.force(t, q, v));
        differences(v, f_v, |v| self.force(t, q, v));
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
        self.along(q, f_q, |q| self.total(t, q, v));
        differences(v, f_v, |v| self.total(t, q, v));
        self.along(q, p_q, |q| self.mass(q) * v);
    }
    fn acceleration(&self, t: f64, q: &SVector<f64, Q>, acceleration: &mut SVector<f64, N>) {
        if T::STRUCTURE.constant_mass && !T::STRUCTURE.velocity_forces {
            *acceleration = self.inverse * self.force(t, q, &SVector::zeros());
        }
    }
    fn potential_energy(&self, q: &SVector<f64, Q>) -> f64 {
        self.scene.potential(entries(q))
    }
    fn nonconservative_power(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        self.scene.power(t, entries(q), entries(v))
    }
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Observables<Q, N, R>
    for Hand<T, Q, N, R>
{
    type Outputs = ();

    fn outputs(&self, _: f64, _: &SVector<f64, Q>, _: &SVector<f64, N>, _: &mut [f64]) {}
    fn events(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, events: &mut [f64]) {
        if let Some(event) = events.first_mut() {
            *event = self.scene.event(t, entries(q), entries(v));
        }
    }
    fn points(&self, _: f64, _: &SVector<f64, Q>, _: &mut [[f64; 3]]) {}
    fn reactions(
        &self,
        _: f64,
        _: &SVector<f64, Q>,
        _: &SVector<f64, N>,
        _: &SVector<f64, N>,
        _: &SVector<f64, R>,
        _: &mut [f64],
    ) {
    }
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> System<Q, N, R>
    for Hand<T, Q, N, R>
{
    const MODEL: &'static Model = &Model {
        name: "Hand",
        doc: "",
        declaration: "",
        world: World::Planar,
        up: [0.0, 1.0, 0.0],
        coordinates: &[],
        velocities: &[],
        rows: T::ROWS,
        parts: &[],
        parameters: &[],
        inputs: &[],
        outputs: &[],
        events: T::EVENTS,
        points: &[],
        segments: &[],
        reactions: &[],
        reductions: &[],
        operations: &[],
        structure: T::STRUCTURE,
        mobility: None,
        formulation: "Natural",
        candidates: &[],
    };
    const STRUCTURE: Structure = T::STRUCTURE;
}
