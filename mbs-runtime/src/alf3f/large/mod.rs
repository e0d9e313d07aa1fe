//! Large mechanisms of every structure: varying M, forces that depend on velocities, rotations, nonholonomic and
//! redundant rows. The step is the [implicit one](super::implicit_step); its matrices are sparse.

#[cfg(feature = "sparse")]
mod matrices;
#[cfg(feature = "sparse")]
mod step;
#[cfg(feature = "sparse")]
mod tangents;
#[cfg(not(feature = "sparse"))]
mod without;

#[cfg(feature = "sparse")]
pub(super) use step::SparseStep;
#[cfg(not(feature = "sparse"))]
pub(super) use without::SparseStep;
