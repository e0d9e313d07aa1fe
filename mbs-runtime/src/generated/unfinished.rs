//! The equations of a declaration that did not compile.

use crate::{
    Configuration, Constraints, Inertia, Loads, MatrixSink, Model, NamedValues, Observables,
    Structure, System, TensorSink, World,
};
use core::marker::PhantomData;
use nalgebra::{SMatrix, SVector};

/// The number of its coordinates and velocities, which are not known: the most to which nalgebra gives names, so that
/// `positions().x` is no second error.
pub const SIZE: usize = 6;

type Vector = SVector<f64, SIZE>;
type Rows = SVector<f64, 0>;
type Columns = SMatrix<f64, SIZE, 0>;

/// The system of a declaration with errors, so that rustc shows only the errors of the declaration.
#[derive(Debug, Clone, Default)]
pub struct Unfinished<I, O>(PhantomData<(I, O)>);

/// The model of a declaration that did not compile.
pub const UNFINISHED: &Model = &Model {
    name: "",
    doc: "",
    declaration: "",
    world: World::Planar,
    up: [0.0, 1.0, 0.0],
    coordinates: &[],
    velocities: &[],
    rows: &[],
    parts: &[],
    parameters: &[],
    inputs: &[],
    outputs: &[],
    events: &[],
    points: &[],
    marks: 0,
    segments: &[],
    reactions: &[],
    reductions: &[],
    operations: &[],
    structure: Structure {
        constant_mass: true,
        velocity_forces: false,
        position_forces: false,
        time_dependent: false,
        rheonomic: false,
        smooth: true,
        holonomic_rows: 0,
        rotations: 0,
    },
    mobility: None,
    formulation: "Natural",
    candidates: &[],
};

impl<I: NamedValues, O: NamedValues> Configuration<SIZE, SIZE> for Unfinished<I, O> {
    const ROTATIONS: &'static [usize] = &[];

    fn guess(&self) -> (Vector, Vector) {
        (SVector::zeros(), SVector::zeros())
    }
    fn advance(&self, _: &Vector, _: &Vector, _: f64) -> Vector {
        SVector::zeros()
    }
    fn difference(&self, _: &Vector, _: &Vector) -> Vector {
        SVector::zeros()
    }
    fn free_flight(&self, _: &mut Vector, _: &mut Vector, _: f64) {}
}

impl<I: NamedValues, O: NamedValues> Inertia<SIZE, SIZE> for Unfinished<I, O> {
    type Mass = ();

    fn mass_matrix(&self, _: &Vector, _: &mut impl MatrixSink) {}
    fn factor_mass(&self, _: &Vector) -> Option<()> {
        Some(())
    }
    fn solve_mass(&self, _: &(), _: &mut Vector) {}
    fn momentum(&self, _: &Vector, _: &Vector, _: &mut Vector) {}
    fn affinities(&self, _: &Vector, _: &mut impl TensorSink) {}
    fn kinetic_energy(&self, _: &Vector, _: &Vector) -> f64 {
        0.0
    }
}

impl<I: NamedValues, O: NamedValues> Constraints<SIZE, SIZE, 0> for Unfinished<I, O> {
    fn holonomic(&self, _: f64, _: &Vector, _: &mut Rows) {}
    fn constraints(&self, _: f64, _: &Vector, _: &mut Rows, _: &mut impl MatrixSink, _: &mut Rows) {
    }
    fn constraint_rates(
        &self,
        _: f64,
        _: &Vector,
        _: &Vector,
        _: &mut impl MatrixSink,
        _: &mut Rows,
    ) {
    }
    fn solve_mass_rows(&self, _: &(), _: &Columns, _: &mut Columns) {}
    fn delassus(&self, _: &Columns, _: &Columns, _: &mut SMatrix<f64, 0, 0>) {}
}

impl<I: NamedValues, O: NamedValues> Loads<SIZE, SIZE> for Unfinished<I, O> {
    type Inputs = I;

    fn inputs(&self) -> &[f64] {
        &[]
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        &mut []
    }
    fn applied_forces(&self, _: f64, _: &Vector, _: &Vector, _: &mut Vector) {}
    fn forces(&self, _: f64, _: &Vector, _: &Vector, _: &mut Vector) {}
    fn applied_force_tangents(
        &self,
        _: f64,
        _: &Vector,
        _: &Vector,
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
    ) {
    }
    fn force_tangents(
        &self,
        _: f64,
        _: &Vector,
        _: &Vector,
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
    ) {
    }
    fn acceleration(&self, _: f64, _: &Vector, _: &mut Vector) {}
    fn potential_energy(&self, _: &Vector) -> f64 {
        0.0
    }
    fn nonconservative_power(&self, _: f64, _: &Vector, _: &Vector) -> f64 {
        0.0
    }
}

impl<I: NamedValues, O: NamedValues> Observables<SIZE, SIZE, 0> for Unfinished<I, O> {
    type Outputs = O;

    fn outputs(&self, _: f64, _: &Vector, _: &Vector, _: &mut [f64]) {}
    fn events(&self, _: f64, _: &Vector, _: &Vector, _: &mut [f64]) {}
    fn points(&self, _: f64, _: &Vector, _: &mut [[f64; 3]]) {}
    fn reactions(&self, _: f64, _: &Vector, _: &Vector, _: &Vector, _: &Rows, _: &mut [f64]) {}
}

impl<I: NamedValues, O: NamedValues> System<SIZE, SIZE, 0> for Unfinished<I, O> {
    const MODEL: &'static Model = UNFINISHED;
    const STRUCTURE: Structure = UNFINISHED.structure;
}
