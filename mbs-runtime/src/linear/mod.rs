//! Small dense kernels on matrices of fixed size, and elimination without zeros. None allocates; all accept size 0.

use crate::memory::OnDemand;

mod delassus_factor;
mod kept_rows;
pub(crate) mod lanes;
mod pivoted;
mod projection_lu;
mod proximal;
#[cfg(feature = "std")]
mod rank;
mod row_matrix;
#[cfg(feature = "std")]
pub(crate) mod sparse;
mod vector;

pub(crate) use delassus_factor::DelassusFactor;
pub(crate) use pivoted::Pivoted;
pub(crate) use projection_lu::ProjectionLu;
#[cfg(feature = "std")]
pub(crate) use rank::{Dependence, dependence};
pub(crate) use row_matrix::{RowMatrix, rows};
pub(crate) use vector::{
    accumulate, add, add_scaled, added, array, dot, dot_of, finite, larger, largest, largest_of,
    negative, products, scaled, vector, zeros,
};
pub use vector::{entries, entries_mut};

/// The entries of a matrix inside a solver, row by row.
type Square<const K: usize> = OnDemand<[[f64; K]; K]>;

/// From this size on, a branch that skips a zero is cheaper than the row operation it saves.
const SPARSE_FROM: usize = 16;
