//! Sparse matrices of any pattern, and their factors; those of the steps are by faer.

mod dependence;
mod entries;
mod ldl;
#[cfg(feature = "sparse")]
mod lu;
#[cfg(feature = "sparse")]
mod pattern;
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
