//! Sparse matrices of any pattern, and their factors; those of the steps are by faer.

mod dependence;
mod entries;
#[cfg(feature = "sparse")]
mod frontal;
#[cfg(feature = "sparse")]
mod fronts;
mod ldl;
#[cfg(feature = "sparse")]
mod lu;
#[cfg(feature = "sparse")]
mod panels;
#[cfg(feature = "sparse")]
mod pattern;
#[cfg(feature = "sparse")]
mod pivoted_lu;
mod rows;
#[cfg(feature = "sparse")]
mod saddle;

pub(crate) use dependence::dependence;
pub(crate) use entries::{Entries, Recorder};
pub(crate) use ldl::Ldl;
#[cfg(feature = "sparse")]
pub(crate) use lu::SparseLu;
#[cfg(feature = "sparse")]
pub(crate) use pattern::{Columns, Pattern};
pub(crate) use rows::SparseRows;
#[cfg(feature = "sparse")]
pub(crate) use saddle::Saddle;
