//! Hand-written mechanisms: what `mechanism!` would generate, as plainly as possible.
#![allow(dead_code)]

pub mod alloc;
pub mod planar;
pub mod scenes;

use mbs_runtime::{
    MatrixSink, Mechanism, Model, ParameterError, Row, RowKind, Structure, System, TensorSink,
    UnknownName,
};

/// The equations of a scene; the rest is filled in by [`Hand`], tangents by central differences.
pub trait Scene<const N: usize, const R: usize>: Clone + Default {
    const STRUCTURE: Structure;
    const ROWS: &'static [Row] = &[];
    const EVENTS: &'static [&'static str] = &[];
    fn guess(&self) -> ([f64; N], [f64; N]);
    fn mass(&self, q: &[f64; N]) -> [[f64; N]; N];
    fn force(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N];
    /// ∂T/∂q.
    fn kinetic_gradient(&self, _q: &[f64; N], _v: &[f64; N]) -> [f64; N] {
        [0.0; N]
    }
    /// φ, A, b.
    fn rows(&self, t: f64, q: &[f64; N]) -> ([f64; R], [[f64; N]; R], [f64; R]);
    fn potential(&self, q: &[f64; N]) -> f64;
    fn power(&self, _t: f64, _q: &[f64; N], _v: &[f64; N]) -> f64 {
        0.0
    }
    fn event(&self, _t: f64, _q: &[f64; N], _v: &[f64; N]) -> f64 {
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
pub struct Parameters<T, const N: usize, const R: usize>(pub T);

impl<T: Scene<N, R>, const N: usize, const R: usize> Mechanism for Parameters<T, N, R> {
    type System = Hand<T, N, R>;
    const MODEL: &'static Model = <Hand<T, N, R> as System<N, R>>::MODEL;
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
pub struct Hand<T, const N: usize, const R: usize> {
    pub scene: T,
    inverse: [[f64; N]; N],
    inputs: [f64; 1],
}

impl<T: Scene<N, R>, const N: usize, const R: usize> Hand<T, N, R> {
    pub fn new(scene: T) -> Self {
        let inverse = invert(scene.mass(&scene.guess().0));
        Hand {
            scene,
            inverse,
            inputs: [0.0],
        }
    }
    fn total(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        let (f, g) = (self.scene.force(t, q, v), self.scene.kinetic_gradient(q, v));
        std::array::from_fn(|i| f[i] + g[i])
    }
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

impl<T: Scene<N, R>, const N: usize, const R: usize> System<N, R> for Hand<T, N, R> {
    const MODEL: &'static Model = &Model {
        name: "Hand",
        doc: "",
        declaration: "",
        coordinates: &[],
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
    };
    const STRUCTURE: Structure = T::STRUCTURE;
    type Mass = [[f64; N]; N];

    fn inputs(&self) -> &[f64] {
        &self.inputs
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        &mut self.inputs
    }
    fn guess(&self) -> ([f64; N], [f64; N]) {
        self.scene.guess()
    }
    fn mass_matrix(&self, q: &[f64; N], mass: &mut impl MatrixSink) {
        let m = self.scene.mass(q);
        for i in 0..N {
            for j in 0..N {
                mass.set(i, j, m[i][j]);
            }
        }
    }
    fn factor_mass(&self, q: &[f64; N]) -> Option<Self::Mass> {
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
    fn gram(&self, a: &[[f64; N]; R], w: &[[f64; N]; R], gram: &mut [[f64; R]; R]) {
        for i in 0..R {
            for j in 0..R {
                gram[i][j] = (0..N).map(|k| a[i][k] * w[j][k]).sum();
            }
        }
    }
    fn momentum(&self, q: &[f64; N], v: &[f64; N], p: &mut [f64; N]) {
        *p = times(&self.scene.mass(q), v);
    }
    fn affinities(&self, q: &[f64; N], gamma: &mut impl TensorSink) {
        let e = 1e-6;
        let slope: [[[f64; N]; N]; N] = std::array::from_fn(|k| {
            let (mut up, mut down) = (*q, *q);
            up[k] += e;
            down[k] -= e;
            let (up, down) = (self.scene.mass(&up), self.scene.mass(&down));
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
    fn holonomic(&self, t: f64, q: &[f64; N], phi: &mut [f64; R]) {
        *phi = self.scene.rows(t, q).0;
    }
    fn constraints(
        &self,
        t: f64,
        q: &[f64; N],
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
        q: &[f64; N],
        v: &[f64; N],
        a_rate: &mut impl MatrixSink,
        gamma: &mut [f64; R],
    ) {
        let e = 1e-6;
        let at = |e: f64| {
            self.scene
                .rows(t + e, &std::array::from_fn(|i| q[i] + e * v[i]))
        };
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
    fn applied_forces(&self, t: f64, q: &[f64; N], v: &[f64; N], f: &mut [f64; N]) {
        *f = self.scene.force(t, q, v);
    }
    fn forces(&self, t: f64, q: &[f64; N], v: &[f64; N], f: &mut [f64; N]) {
        *f = self.total(t, q, v);
    }
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &[f64; N],
        v: &[f64; N],
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    ) {
        differences(q, f_q, |q| self.scene.force(t, q, v));
        differences(v, f_v, |v| self.scene.force(t, q, v));
    }
    fn force_tangents(
        &self,
        t: f64,
        q: &[f64; N],
        v: &[f64; N],
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    ) {
        differences(q, f_q, |q| self.total(t, q, v));
        differences(v, f_v, |v| self.total(t, q, v));
        differences(q, p_q, |q| times(&self.scene.mass(q), v));
    }
    fn acceleration(&self, t: f64, q: &[f64; N], acceleration: &mut [f64; N]) {
        if T::STRUCTURE.constant_mass && !T::STRUCTURE.velocity_forces {
            *acceleration = times(&self.inverse, &self.scene.force(t, q, &[0.0; N]));
        }
    }
    fn kinetic_energy(&self, q: &[f64; N], v: &[f64; N]) -> f64 {
        let p = times(&self.scene.mass(q), v);
        0.5 * (0..N).map(|i| p[i] * v[i]).sum::<f64>()
    }
    fn potential_energy(&self, q: &[f64; N]) -> f64 {
        self.scene.potential(q)
    }
    fn nonconservative_power(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> f64 {
        self.scene.power(t, q, v)
    }
    fn outputs(&self, _: f64, _: &[f64; N], _: &[f64; N], _: &mut [f64]) {}
    fn events(&self, t: f64, q: &[f64; N], v: &[f64; N], events: &mut [f64]) {
        if let Some(event) = events.first_mut() {
            *event = self.scene.event(t, q, v);
        }
    }
    fn points(&self, _: f64, _: &[f64; N], _: &mut [[f64; 3]]) {}
    fn reactions(
        &self,
        _: f64,
        _: &[f64; N],
        _: &[f64; N],
        _: &[f64; N],
        _: &[f64; R],
        _: &mut [f64],
    ) {
    }
}
