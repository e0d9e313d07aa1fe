//! Large mechanisms of every structure: varying M, forces that depend on velocities, rotations, nonholonomic and
//! redundant rows. The step is the [implicit one](super::implicit_step); its matrices are sparse, and factors are kept
//! over many steps.

#[cfg(feature = "sparse")]
mod balance;
#[cfg(feature = "sparse")]
mod matrices;
#[cfg(feature = "sparse")]
mod projection;
#[cfg(feature = "sparse")]
mod step;
#[cfg(feature = "sparse")]
mod tangents;
#[cfg(feature = "sparse")]
mod turns;
#[cfg(not(feature = "sparse"))]
mod without;

#[cfg(feature = "sparse")]
pub(super) use step::SparseStep;
#[cfg(not(feature = "sparse"))]
pub(super) use without::SparseStep;

/// A step in the list of flows: without the feature a type without values, so that the list has one flow less.
#[cfg(feature = "sparse")]
pub(super) type LargeStep<const Q: usize, const N: usize, const R: usize> =
    crate::memory::Box<SparseStep<Q, N, R>>;
#[cfg(not(feature = "sparse"))]
pub(super) type LargeStep<const Q: usize, const N: usize, const R: usize> = SparseStep<Q, N, R>;
