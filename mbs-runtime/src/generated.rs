//! What generated code calls. Public because it runs in users' crates; not meant to be called by hand.

use crate::{MatrixSink, Model, ParameterError, Structure, System, TensorSink, World};

pub use cholesky::{Cholesky, positive};
pub use elimination::{DEPENDENT, Elimination, Rates};
pub use rotation::{rotation_between, turned};
pub use spin::Spin;

mod cholesky;
mod elimination;
mod principal;
mod rotation;
mod spin;

/// A pivot below this part of what it began with is round-off.
const ROUND_OFF: f64 = 1e-12;

/// 1/d of a pivot d that began as `whole`; 0 where d is round-off beside it: its row depends on those before it.
#[inline(always)]
pub fn pivot_inverse(pivot: f64, whole: f64) -> f64 {
    if pivot > ROUND_OFF * whole {
        1.0 / pivot
    } else {
        0.0
    }
}

/// −1, 0 or 1.
#[inline]
pub fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// 1 where `x` is positive, else 0.
#[inline]
pub fn step(x: f64) -> f64 {
    if x > 0.0 { 1.0 } else { 0.0 }
}

/// Refuses a parameter that is not finite.
///
/// # Errors
/// [`ParameterError::NotFinite`].
pub fn check_finite(name: &'static str, value: f64) -> Result<(), ParameterError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(ParameterError::NotFinite { name, value })
    }
}

/// q + h v: [`System::advance`] where no coordinate is a rotation.
#[inline]
pub fn translated<const N: usize>(q: &[f64; N], v: &[f64; N], h: f64) -> [f64; N] {
    std::array::from_fn(|i| q[i] + h * v[i])
}

/// to − from: [`System::difference`] where no coordinate is a rotation.
#[inline]
pub fn displacement<const N: usize>(from: &[f64; N], to: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| to[i] - from[i])
}

/// M⁻¹ of a constant mass matrix.
///
/// # Errors
/// [`ParameterError::MassNotPositive`] at the coordinate where M stops being positive definite.
pub fn inverse_mass<const N: usize>(
    mass: &[[f64; N]; N],
    coordinates: &[&'static str; N],
) -> Result<[[f64; N]; N], ParameterError> {
    let factor = Cholesky::factor(mass).map_err(|column| ParameterError::MassNotPositive {
        coordinate: coordinates[column],
    })?;
    let mut inverse = [[0.0; N]; N];
    for (i, row) in inverse.iter_mut().enumerate() {
        row[i] = 1.0;
        factor.solve(row);
    }
    // Exactly symmetric: generated code reads one triangle.
    for i in 0..N {
        for j in 0..i {
            inverse[i][j] = inverse[j][i];
        }
    }
    Ok(inverse)
}

/// x ← M⁻¹ x.
pub fn multiply<const N: usize>(inverse: &[[f64; N]; N], x: &mut [f64; N]) {
    let old = *x;
    for (value, row) in x.iter_mut().zip(inverse) {
        *value = row.iter().zip(&old).map(|(m, x)| m * x).sum();
    }
}

/// w = M⁻¹ a, row by row, skipping the zeros of a.
pub fn multiply_rows<const N: usize, const R: usize>(
    inverse: &[[f64; N]; N],
    a: &[[f64; N]; R],
    w: &mut [[f64; N]; R],
) {
    for (w, a) in w.iter_mut().zip(a) {
        *w = [0.0; N];
        for (&entry, column) in a.iter().zip(inverse) {
            if entry != 0.0 {
                for (w, m) in w.iter_mut().zip(column) {
                    *w += entry * m;
                }
            }
        }
    }
}

/// delassus = A Wᵀ, skipping the zeros of A.
pub fn delassus<const N: usize, const R: usize>(
    a: &[[f64; N]; R],
    w: &[[f64; N]; R],
    delassus: &mut [[f64; R]; R],
) {
    for (row, a) in delassus.iter_mut().zip(a) {
        *row = [0.0; R];
        for (column, &entry) in a.iter().enumerate() {
            if entry != 0.0 {
                for (value, w) in row.iter_mut().zip(w) {
                    *value += entry * w[column];
                }
            }
        }
    }
}

/// The system of a declaration that did not compile: it exists so that only the declaration's own errors are shown.
#[derive(Debug, Clone)]
pub struct Unfinished;

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

impl System<0, 0, 0> for Unfinished {
    const MODEL: &'static Model = UNFINISHED;
    const STRUCTURE: Structure = UNFINISHED.structure;
    const ROTATIONS: &'static [usize] = &[];
    type Mass = ();

    fn inputs(&self) -> &[f64] {
        &[]
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        &mut []
    }
    fn guess(&self) -> ([f64; 0], [f64; 0]) {
        ([], [])
    }
    fn advance(&self, _: &[f64; 0], _: &[f64; 0], _: f64) -> [f64; 0] {
        []
    }
    fn difference(&self, _: &[f64; 0], _: &[f64; 0]) -> [f64; 0] {
        []
    }
    fn free_flight(&self, _: &mut [f64; 0], _: &mut [f64; 0], _: f64) {}
    fn mass_matrix(&self, _: &[f64; 0], _: &mut impl MatrixSink) {}
    fn factor_mass(&self, _: &[f64; 0]) -> Option<()> {
        Some(())
    }
    fn solve_mass(&self, _: &(), _: &mut [f64; 0]) {}
    fn solve_mass_rows(&self, _: &(), _: &[[f64; 0]; 0], _: &mut [[f64; 0]; 0]) {}
    fn delassus(&self, _: &[[f64; 0]; 0], _: &[[f64; 0]; 0], _: &mut [[f64; 0]; 0]) {}
    fn momentum(&self, _: &[f64; 0], _: &[f64; 0], _: &mut [f64; 0]) {}
    fn affinities(&self, _: &[f64; 0], _: &mut impl TensorSink) {}
    fn holonomic(&self, _: f64, _: &[f64; 0], _: &mut [f64; 0]) {}
    fn constraints(
        &self,
        _: f64,
        _: &[f64; 0],
        _: &mut [f64; 0],
        _: &mut impl MatrixSink,
        _: &mut [f64; 0],
    ) {
    }
    fn constraint_rates(
        &self,
        _: f64,
        _: &[f64; 0],
        _: &[f64; 0],
        _: &mut impl MatrixSink,
        _: &mut [f64; 0],
    ) {
    }
    fn applied_forces(&self, _: f64, _: &[f64; 0], _: &[f64; 0], _: &mut [f64; 0]) {}
    fn forces(&self, _: f64, _: &[f64; 0], _: &[f64; 0], _: &mut [f64; 0]) {}
    fn applied_force_tangents(
        &self,
        _: f64,
        _: &[f64; 0],
        _: &[f64; 0],
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
    ) {
    }
    fn force_tangents(
        &self,
        _: f64,
        _: &[f64; 0],
        _: &[f64; 0],
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
        _: &mut impl MatrixSink,
    ) {
    }
    fn acceleration(&self, _: f64, _: &[f64; 0], _: &mut [f64; 0]) {}
    fn kinetic_energy(&self, _: &[f64; 0], _: &[f64; 0]) -> f64 {
        0.0
    }
    fn potential_energy(&self, _: &[f64; 0]) -> f64 {
        0.0
    }
    fn nonconservative_power(&self, _: f64, _: &[f64; 0], _: &[f64; 0]) -> f64 {
        0.0
    }
    fn outputs(&self, _: f64, _: &[f64; 0], _: &[f64; 0], _: &mut [f64]) {}
    fn events(&self, _: f64, _: &[f64; 0], _: &[f64; 0], _: &mut [f64]) {}
    fn points(&self, _: f64, _: &[f64; 0], _: &mut [[f64; 3]]) {}
    fn reactions(
        &self,
        _: f64,
        _: &[f64; 0],
        _: &[f64; 0],
        _: &[f64; 0],
        _: &[f64; 0],
        _: &mut [f64],
    ) {
    }
}
