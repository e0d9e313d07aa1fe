//! Hand-written mechanisms: what `mechanism!` would generate, as plainly as possible. Sums over entries are loops over
//! arrays: without optimisation these are ten times as fast as the same operations of nalgebra.
#![allow(dead_code)]

pub mod alloc;
mod arrays;
pub mod bennett;
pub mod bricard;
pub mod planar;
pub mod scenes;
pub mod space;
pub mod spatial;

use self::arrays::{differences, dot, part, put, solved};
pub use self::arrays::{distance, matrix, unit};
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
        rheonomic: true,
        smooth: false,
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
    /// M of the guess: of all poses, if M is constant.
    start: [[f64; N]; N],
    inverse: SMatrix<f64, N, N>,
    spins: Vec<Spin>,
    inputs: [f64; 1],
}

impl<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize> Hand<T, Q, N, R> {
    pub fn new(scene: T) -> Self {
        let start = scene.mass(&scene.guess().0);
        Hand {
            spins: scene.spins(),
            start,
            inverse: matrix(start).try_inverse().unwrap(),
            scene,
            inputs: [0.0],
        }
    }
    /// Calls `entry(i in q, j in v, the number of the rotation that begins there)`.
    fn each(mut entry: impl FnMut(usize, usize, Option<usize>)) {
        let (mut i, mut j, mut number) = (0, 0, 0);
        while j < N {
            if T::ROTATIONS.get(number) == Some(&j) {
                entry(i, j, Some(number));
                (i, j, number) = (i + 4, j + 3, number + 1);
            } else {
                entry(i, j, None);
                (i, j) = (i + 1, j + 1);
            }
        }
    }
    fn mass(&self, q: &SVector<f64, Q>) -> [[f64; N]; N] {
        match T::STRUCTURE.constant_mass {
            true => self.start,
            false => self.scene.mass(entries(q)),
        }
    }
    fn momenta(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> [f64; N] {
        let (mass, v) = (self.mass(q), entries(v));
        let mut p = [0.0; N];
        let mut i = 0;
        while i < N {
            p[i] = dot(&mass[i], v);
            i += 1;
        }
        p
    }
    fn force(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> [f64; N] {
        self.scene.force(t, entries(q), entries(v))
    }
    fn total(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> [f64; N] {
        let mut total = self.force(t, q, v);
        let gradient = self.scene.kinetic_gradient(entries(q), entries(v));
        let mut i = 0;
        while i < N {
            total[i] += gradient[i];
            i += 1;
        }
        total
    }
    /// Column by column D_j f, by central differences along the velocities; zero unless f `varies`.
    fn along(
        &self,
        varies: bool,
        q: &SVector<f64, Q>,
        sink: &mut impl MatrixSink,
        f: impl Fn(&SVector<f64, Q>) -> [f64; N],
    ) {
        let way = SVector::zeros();
        differences(varies, &way, sink, |way| f(&self.advance(q, way, 1.0)));
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
        let (q, v) = (entries(q), entries(v));
        let mut next = *q;
        Self::each(|i, j, rotation| match rotation {
            None => next[i] = q[i] + h * v[j],
            Some(_) => next[i..i + 4].copy_from_slice(&turned(part(q, i), part(v, j), h)),
        });
        next.into()
    }
    fn difference(&self, from: &SVector<f64, Q>, to: &SVector<f64, Q>) -> SVector<f64, N> {
        let (from, to) = (entries(from), entries(to));
        let mut way = [0.0; N];
        Self::each(|i, j, rotation| match rotation {
            None => way[j] = to[i] - from[i],
            Some(_) => {
                way[j..j + 3].copy_from_slice(&rotation_between(part(from, i), part(to, i)));
            }
        });
        way.into()
    }
    fn free_flight(&self, q: &mut SVector<f64, Q>, v: &mut SVector<f64, N>, h: f64) {
        let mut next = self.advance(q, v, h);
        Self::each(|i, j, rotation| {
            if let Some(number) = rotation {
                let (q, omega) = (part(entries(q), i), part(entries(v), j));
                let (turned, omega) = self.spins[number].flight(q, omega, h);
                next.as_mut_slice()[i..i + 4].copy_from_slice(&turned);
                v.as_mut_slice()[j..j + 3].copy_from_slice(&omega);
            }
        });
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
        match T::STRUCTURE.constant_mass {
            true => Some(self.inverse),
            false => matrix(self.mass(q)).try_inverse(),
        }
    }
    fn solve_mass(&self, mass: &Self::Mass, x: &mut SVector<f64, N>) {
        *x = solved(mass, entries(x)).into();
    }
    fn momentum(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, p: &mut SVector<f64, N>) {
        *p = self.momenta(q, v).into();
    }
    fn affinities(&self, q: &SVector<f64, Q>, gamma: &mut impl TensorSink) {
        let e = 1e-6;
        let slope: [SMatrix<f64, N, N>; N] = std::array::from_fn(|k| {
            let at = |e: f64| matrix(self.mass(&self.advance(q, &unit(k), e)));
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
        0.5 * dot(entries(v), &self.momenta(q, v))
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
        put(&rows.1, a);
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
            (a, b)
        };
        let (mut up, down) = (at(e), at(-e));
        let mut i = 0;
        while i < R {
            let mut j = 0;
            while j < N {
                up.0[i][j] = (up.0[i][j] - down.0[i][j]) / (2.0 * e);
                j += 1;
            }
            gamma[i] = (up.1[i] - down.1[i]) / (2.0 * e) + dot(&up.0[i], entries(v));
            i += 1;
        }
        put(&up.0, a_rate);
    }
    fn solve_mass_rows(
        &self,
        mass: &Self::Mass,
        a: &SMatrix<f64, N, R>,
        w: &mut SMatrix<f64, N, R>,
    ) {
        let mut i = 0;
        while i < R {
            w.data.0[i] = solved(mass, &a.data.0[i]);
            i += 1;
        }
    }
    fn delassus(
        &self,
        a: &SMatrix<f64, N, R>,
        w: &SMatrix<f64, N, R>,
        delassus: &mut SMatrix<f64, R, R>,
    ) {
        let (a, w) = (&a.data.0, &w.data.0);
        let mut i = 0;
        while i < R {
            let mut sums = [0.0; R];
            let mut k = 0;
            while k < N {
                // Most entries of A are zero.
                if a[i][k] != 0.0 {
                    let mut j = 0;
                    while j < R {
                        sums[j] += a[i][k] * w[j][k];
                        j += 1;
                    }
                }
                k += 1;
            }
            delassus.data.0[i] = sums;
            i += 1;
        }
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
        *f = self.force(t, q, v).into();
    }
    fn forces(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f: &mut SVector<f64, N>) {
        *f = self.total(t, q, v).into();
    }
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    ) {
        let structure = T::STRUCTURE;
        self.along(structure.position_forces, q, f_q, |q| self.force(t, q, v));
        differences(structure.velocity_forces, v, f_v, |v| self.force(t, q, v));
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
        let structure = T::STRUCTURE;
        let mass_varies = !structure.constant_mass;
        let with_positions = structure.position_forces || mass_varies;
        let with_velocities = structure.velocity_forces || mass_varies || structure.rotations > 0;
        self.along(with_positions, q, f_q, |q| self.total(t, q, v));
        differences(with_velocities, v, f_v, |v| self.total(t, q, v));
        self.along(mass_varies, q, p_q, |q| self.momenta(q, v));
    }
    fn acceleration(&self, t: f64, q: &SVector<f64, Q>, acceleration: &mut SVector<f64, N>) {
        if T::STRUCTURE.constant_mass && !T::STRUCTURE.velocity_forces {
            *acceleration = solved(&self.inverse, &self.force(t, q, &SVector::zeros())).into();
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
        marks: 0,
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
