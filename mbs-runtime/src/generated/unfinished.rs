//! The equations of a declaration that did not compile.

use crate::{
    Configuration, Constraints, Inertia, Loads, MatrixSink, Model, NamedValues, Observables,
    Structure, System, TensorSink, World,
};
use core::marker::PhantomData;
use nalgebra::{SMatrix, SVector};

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
    segments: &[],
    reactions: &[],
    reductions: &[],
    operations: &[],
    structure: Structure {
        constant_mass: true,
        velocity_forces: false,
        position_forces: false,
        time_dependent: false,
        holonomic_rows: 0,
        rotations: 0,
    },
    mobility: None,
    formulation: "Natural",
    candidates: &[],
};

impl<I: NamedValues, O: NamedValues> Configuration<0, 0> for Unfinished<I, O> {
    const ROTATIONS: &'static [usize] = &[];

    fn guess(&self) -> (SVector<f64, 0>, SVector<f64, 0>) {
        (SVector::zeros(), SVector::zeros())
    }
    fn advance(&self, _: &SVector<f64, 0>, _: &SVector<f64, 0>, _: f64) -> SVector<f64, 0> {
        SVector::zeros()
    }
    fn difference(&self, _: &SVector<f64, 0>, _: &SVector<f64, 0>) -> SVector<f64, 0> {
        SVector::zeros()
    }
    fn free_flight(&self, _: &mut SVector<f64, 0>, _: &mut SVector<f64, 0>, _: f64) {}
}

impl<I: NamedValues, O: NamedValues> Inertia<0, 0> for Unfinished<I, O> {
    type Mass = ();

    fn mass_matrix(&self, _: &SVector<f64, 0>, _: &mut impl MatrixSink) {}
    fn factor_mass(&self, _: &SVector<f64, 0>) -> Option<()> {
        Some(())
    }
    fn solve_mass(&self, _: &(), _: &mut SVector<f64, 0>) {}
    fn momentum(&self, _: &SVector<f64, 0>, _: &SVector<f64, 0>, _: &mut SVector<f64, 0>) {}
    fn affinities(&self, _: &SVector<f64, 0>, _: &mut impl TensorSink) {}
    fn kinetic_energy(&self, _: &SVector<f64, 0>, _: &SVector<f64, 0>) -> f64 {
        0.0
    }
}

impl<I: NamedValues, O: NamedValues> Constraints<0, 0, 0> for Unfinished<I, O> {
    fn holonomic(&self, _: f64, _: &SVector<f64, 0>, _: &mut SVector<f64, 0>) {}
    fn constraints(
        &self,
        _: f64,
        _: &SVector<f64, 0>,
        _: &mut SVector<f64, 0>,
        _: &mut impl MatrixSink,
        _: &mut SVector<f64, 0>,
    ) {
    }
    fn constraint_rates(
        &self,
        _: f64,
        _: &SVector<f64, 0>,
        _: &SVector<f64, 0>,
        _: &mut impl MatrixSink,
        _: &mut SVector<f64, 0>,
    ) {
    }
    fn solve_mass_rows(&self, _: &(), _: &SMatrix<f64, 0, 0>, _: &mut SMatrix<f64, 0, 0>) {}
    fn delassus(&self, _: &SMatrix<f64, 0, 0>, _: &SMatrix<f64, 0, 0>, _: &mut SMatrix<f64, 0, 0>) {
    }
}

impl<I: NamedValues, O: NamedValues> Loads<0, 0> for Unfinished<I, O> {
    type Inputs = I;

    fn inputs(&self) -> &[f64] {
        &[]
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        &mut []
    }
    fn applied_forces(
        &self,
        _: f64,
        _: &SVector<f64, 0>,
        _: &SVector<f64, 0>,
        _: &mut SVector<f64, 0>,
    ) {
    }
    fn forces(&self, _: f64, _: &SVector<f64, 0>, _: &SVector<f64, 0>, _: &mut SVector<f64, 0>) {}
    fn applied_force_tangents(
        &self,
        _: f64,
        _: &SVector<f64, 0>,
        _: &SVector<f64, 0>,
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
    ) {
    }
    fn force_tangents(
        &self,
        _: f64,
        _: &SVector<f64, 0>,
        _: &SVector<f64, 0>,
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
    ) {
    }
    fn acceleration(&self, _: f64, _: &SVector<f64, 0>, _: &mut SVector<f64, 0>) {}
    fn potential_energy(&self, _: &SVector<f64, 0>) -> f64 {
        0.0
    }
    fn nonconservative_power(&self, _: f64, _: &SVector<f64, 0>, _: &SVector<f64, 0>) -> f64 {
        0.0
    }
}

impl<I: NamedValues, O: NamedValues> Observables<0, 0, 0> for Unfinished<I, O> {
    type Outputs = O;

    fn outputs(&self, _: f64, _: &SVector<f64, 0>, _: &SVector<f64, 0>, _: &mut [f64]) {}
    fn events(&self, _: f64, _: &SVector<f64, 0>, _: &SVector<f64, 0>, _: &mut [f64]) {}
    fn points(&self, _: f64, _: &SVector<f64, 0>, _: &mut [[f64; 3]]) {}
    fn reactions(
        &self,
        _: f64,
        _: &SVector<f64, 0>,
        _: &SVector<f64, 0>,
        _: &SVector<f64, 0>,
        _: &SVector<f64, 0>,
        _: &mut [f64],
    ) {
    }
}

impl<I: NamedValues, O: NamedValues> System<0, 0, 0> for Unfinished<I, O> {
    const MODEL: &'static Model = UNFINISHED;
    const STRUCTURE: Structure = UNFINISHED.structure;
}
