//! Sparse matrices of any pattern, and their factors; on faer.

mod entries;
mod lu;
mod pattern;
mod saddle;

pub(crate) use entries::{Entries, Recorder};
pub(crate) use lu::SparseLu;
pub(crate) use pattern::{Columns, Pattern};
pub(crate) use saddle::Saddle;
