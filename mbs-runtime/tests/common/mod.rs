//! Hand-written mechanisms: what `mechanism!` would generate, as plainly as possible.
#![allow(dead_code)]

pub mod alloc;
pub mod bricard;
pub mod planar;
pub mod scenes;
pub mod space;
pub mod spatial;

use mbs_runtime::generated::{Spin, rotation_between, turned};
use mbs_runtime::{
    MatrixSink, Mechanism, Model, ParameterError, Row, RowKind, Structure, System, TensorSink,
    UnknownName, World,
};

/// The equations of a scene; the rest is filled in by [`Hand`], tangents by central differences.
pub trait Scene<const Q: usize, const N: usize, const R: usize>: Clone + Default {
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
    inverse: [[f64; N]; N],
    spins: Vec<Spin>,
    inputs: [f64; 1],
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Hand<T, Q, N, R> {
    pub fn new(scene: T) -> Self {
        let inverse = invert(scene.mass(&scene.guess().0));
        Hand {
            spins: scene.spins(),
            scene,
            inverse,
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
    fn along(&self, q: &[f64; Q], sink: &mut impl MatrixSink, f: impl Fn(&[f64; Q]) -> [f64; N]) {
        differences(&[0.0; N], sink, |way| f(&self.advance(q, way, 1.0)));
    }
    fn total(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> [f64; N] {
        let (f, g) = (self.scene.force(t, q, v), self.scene.kinetic_gradient(q, v));
        std::array::from_fn(|i| f[i] + g[i])
    }
}

pub fn unit<const N: usize>(j: usize) -> [f64; N] {
    std::array::from_fn(|i| if i == j { 1.0 } else { 0.0 })
}

pub fn invert<const N: usize>(mut m: [[f64; N]; N]) -> [[f64; N]; N] {
    let mut x = [[0.0; N]; N];
    for i in 0..N {
        x[i][i] = 1.0;
    }
    for k in 0..N {
        let pivot = m[k][k];
        for j in 0..N {
            m[k][j] /= pivot;
            x[k][j] /= pivot;
        }
        for i in 0..N {
            if i != k {
                let f = m[i][k];
                for j in 0..N {
                    m[i][j] -= f * m[k][j];
                    x[i][j] -= f * x[k][j];
                }
            }
        }
    }
    x
}

fn times<const N: usize>(m: &[[f64; N]; N], x: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| (0..N).map(|j| m[i][j] * x[j]).sum())
}

fn part<const K: usize>(x: &[f64], i: usize) -> [f64; K] {
    std::array::from_fn(|k| x[i + k])
}

/// Column by column ∂f/∂x by central differences, into a sink.
fn differences<const N: usize>(
    x: &[f64; N],
    sink: &mut impl MatrixSink,
    f: impl Fn(&[f64; N]) -> [f64; N],
) {
    for j in 0..N {
        let e = 1e-6;
        let (mut up, mut down) = (*x, *x);
        up[j] += e;
        down[j] -= e;
        let (up, down) = (f(&up), f(&down));
        for i in 0..N {
            sink.set(i, j, (up[i] - down[i]) / (2.0 * e));
        }
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
    const ROTATIONS: &'static [usize] = T::ROTATIONS;
    type Mass = [[f64; N]; N];

    fn inputs(&self) -> &[f64] {
        &self.inputs
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        &mut self.inputs
    }
    fn guess(&self) -> ([f64; Q], [f64; N]) {
        self.scene.guess()
    }
    fn advance(&self, q: &[f64; Q], v: &[f64; N], h: f64) -> [f64; Q] {
        let next = std::cell::Cell::new(*q);
        let set = |i: usize, values: &[f64]| {
            let mut q = next.get();
            q[i..i + values.len()].copy_from_slice(values);
            next.set(q);
        };
        Self::each(
            |i, j| set(i, &[q[i] + h * v[j]]),
            |i, j, _| set(i, &turned(part(q, i), part(v, j), h)),
        );
        next.get()
    }
    fn difference(&self, from: &[f64; Q], to: &[f64; Q]) -> [f64; N] {
        let way = std::cell::Cell::new([0.0; N]);
        let set = |j: usize, values: &[f64]| {
            let mut v = way.get();
            v[j..j + values.len()].copy_from_slice(values);
            way.set(v);
        };
        Self::each(
            |i, j| set(j, &[to[i] - from[i]]),
            |i, j, _| set(j, &rotation_between(part(from, i), part(to, i))),
        );
        way.get()
    }
    fn free_flight(&self, q: &mut [f64; Q], v: &mut [f64; N], h: f64) {
        let mut next = self.advance(q, v, h);
        Self::each(
            |_, _| {},
            |i, j, number| {
                let (turned, omega) = self.spins[number].flight(part(q, i), part(v, j), h);
                next[i..i + 4].copy_from_slice(&turned);
                v[j..j + 3].copy_from_slice(&omega);
            },
        );
        *q = next;
    }
    fn mass_matrix(&self, q: &[f64; Q], mass: &mut impl MatrixSink) {
        let m = self.scene.mass(q);
        for i in 0..N {
            for j in 0..N {
                mass.set(i, j, m[i][j]);
            }
        }
    }
    fn factor_mass(&self, q: &[f64; Q]) -> Option<Self::Mass> {
        Some(invert(self.scene.mass(q)))
    }
    fn solve_mass(&self, mass: &Self::Mass, x: &mut [f64; N]) {
        *x = times(mass, x);
    }
    fn solve_mass_rows(&self, mass: &Self::Mass, a: &[[f64; N]; R], w: &mut [[f64; N]; R]) {
        for i in 0..R {
            w[i] = times(mass, &a[i]);
        }
    }
    fn delassus(&self, a: &[[f64; N]; R], w: &[[f64; N]; R], delassus: &mut [[f64; R]; R]) {
        for i in 0..R {
            for j in 0..R {
                delassus[i][j] = (0..N).map(|k| a[i][k] * w[j][k]).sum();
            }
        }
    }
    fn momentum(&self, q: &[f64; Q], v: &[f64; N], p: &mut [f64; N]) {
        *p = times(&self.scene.mass(q), v);
    }
    fn affinities(&self, q: &[f64; Q], gamma: &mut impl TensorSink) {
        let e = 1e-6;
        let slope: [[[f64; N]; N]; N] = std::array::from_fn(|k| {
            let at = |e: f64| self.scene.mass(&self.advance(q, &unit(k), e));
            let (up, down) = (at(e), at(-e));
            std::array::from_fn(|i| std::array::from_fn(|j| (up[i][j] - down[i][j]) / (2.0 * e)))
        });
        for i in 0..N {
            for j in 0..N {
                for k in 0..N {
                    gamma.set(
                        i,
                        j,
                        k,
                        0.5 * (slope[k][i][j] + slope[j][i][k] - slope[i][j][k]),
                    );
                }
            }
        }
    }
    fn holonomic(&self, t: f64, q: &[f64; Q], phi: &mut [f64; R]) {
        *phi = self.scene.rows(t, q).0;
    }
    fn constraints(
        &self,
        t: f64,
        q: &[f64; Q],
        phi: &mut [f64; R],
        a: &mut impl MatrixSink,
        b: &mut [f64; R],
    ) {
        let rows = self.scene.rows(t, q);
        *phi = rows.0;
        *b = rows.2;
        for i in 0..R {
            for j in 0..N {
                a.set(i, j, rows.1[i][j]);
            }
        }
    }
    fn constraint_rates(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        a_rate: &mut impl MatrixSink,
        gamma: &mut [f64; R],
    ) {
        let e = 1e-6;
        let at = |e: f64| self.scene.rows(t + e, &self.advance(q, v, e));
        let (up, down) = (at(e), at(-e));
        for i in 0..R {
            gamma[i] = (up.2[i] - down.2[i]) / (2.0 * e);
            for j in 0..N {
                let rate = (up.1[i][j] - down.1[i][j]) / (2.0 * e);
                a_rate.set(i, j, rate);
                gamma[i] += rate * v[j];
            }
        }
    }
    fn applied_forces(&self, t: f64, q: &[f64; Q], v: &[f64; N], f: &mut [f64; N]) {
        *f = self.scene.force(t, q, v);
    }
    fn forces(&self, t: f64, q: &[f64; Q], v: &[f64; N], f: &mut [f64; N]) {
        *f = self.total(t, q, v);
    }
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    ) {
        self.along(q, f_q, |q| self.scene.force(t, q, v));
        differences(v, f_v, |v| self.scene.force(t, q, v));
    }
    fn force_tangents(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    ) {
        self.along(q, f_q, |q| self.total(t, q, v));
        differences(v, f_v, |v| self.total(t, q, v));
        self.along(q, p_q, |q| times(&self.scene.mass(q), v));
    }
    fn acceleration(&self, t: f64, q: &[f64; Q], acceleration: &mut [f64; N]) {
        if T::STRUCTURE.constant_mass && !T::STRUCTURE.velocity_forces {
            *acceleration = times(&self.inverse, &self.scene.force(t, q, &[0.0; N]));
        }
    }
    fn kinetic_energy(&self, q: &[f64; Q], v: &[f64; N]) -> f64 {
        let p = times(&self.scene.mass(q), v);
        0.5 * (0..N).map(|i| p[i] * v[i]).sum::<f64>()
    }
    fn potential_energy(&self, q: &[f64; Q]) -> f64 {
        self.scene.potential(q)
    }
    fn nonconservative_power(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> f64 {
        self.scene.power(t, q, v)
    }
    fn outputs(&self, _: f64, _: &[f64; Q], _: &[f64; N], _: &mut [f64]) {}
    fn events(&self, t: f64, q: &[f64; Q], v: &[f64; N], events: &mut [f64]) {
        if let Some(event) = events.first_mut() {
            *event = self.scene.event(t, q, v);
        }
    }
    fn points(&self, _: f64, _: &[f64; Q], _: &mut [[f64; 3]]) {}
    fn reactions(
        &self,
        _: f64,
        _: &[f64; Q],
        _: &[f64; N],
        _: &[f64; N],
        _: &[f64; R],
        _: &mut [f64],
    ) {
    }
}
