//! The contract between generated code and the runtime.
//!
//! `mechanism!` generates two types. The one that carries the declared name holds the **parameters** as public fields
//! and implements [`Mechanism`](crate::Mechanism). [`Mechanism::prepare`](crate::Mechanism::prepare) turns it into a
//! **system**, in which all quantities that depend only on parameters have been computed; it implements [`System`] and
//! the traits of which it consists, one for each capability. Integrators use only these traits.
//!
//! | symbol | shape | meaning |
//! |---|---|---|
//! | q | Q | generalized coordinates; rotations as unit quaternions (w, x, y, z) that take body axes to space axes |
//! | v | N | generalized velocities, q̇ = G(q) v: rates of translations and angles; angular velocities in body axes |
//! | M | N × N | mass matrix |
//! | φ, ψ̇ | R | constraint rows: holonomic (first [`Structure::holonomic_rows`]), then nonholonomic |
//! | A | R × N | constraint Jacobian: ∂φ/∂q · G, then the coefficients of ψ̇ = N v + n |
//! | b | R | rheonomic part of the velocity rows: φ̇ = A v + b |
//!
//! Derivatives with respect to q are taken along velocities, D_j f = ∂f/∂q · G_j, and have N columns. In the plane G is
//! the identity and Q = N.
//!
//! Vectors are nalgebra's `SVector`. The R rows of A are the columns of an `SMatrix<f64, N, R>`, which holds Aᵀ: one row is
//! contiguous. So are those of W = M⁻¹Aᵀ and the rows of an R × R product. A [`MatrixSink`](crate::MatrixSink) takes entry
//! (row, column) of the matrix that is named.
//!
//! Functions that fill matrices write structurally nonzero entries only: clear the matrix once, when it is made. None
//! of them allocates, except [`Inertia::affinities`] if it is computed at run time.

mod configuration;
mod constraints;
mod elimination;
mod inertia;
#[cfg(feature = "std")]
mod listed;
mod loads;
mod named_values;
mod observables;
mod system;

pub use configuration::Configuration;
pub use constraints::Constraints;
pub use elimination::{Elimination, Kicks, Rates};
pub use inertia::Inertia;
#[cfg(feature = "std")]
pub(crate) use listed::{constraint_rows, force_slopes, mass_rows};
pub use loads::Loads;
pub use named_values::NamedValues;
pub use observables::Observables;
pub use system::System;
