//! Which mechanisms are large: their matrices are sparse.

use crate::{Flow, Method, Settings, System};

/// With fewer velocities and rows dense arrays, held in caches, are the faster.
const FEWEST_UNKNOWNS: usize = 100;

/// Whether there are sparse factors for a mechanism: it is large, and its elimination was not planned when it was
/// compiled. A constant of the mechanism: others do not compile the code for it.
pub(crate) const fn is_large<S, const Q: usize, const N: usize, const R: usize>() -> bool
where
    S: System<Q, N, R>,
{
    cfg!(feature = "sparse") && N + R >= FEWEST_UNKNOWNS && S::ELIMINATION.is_none()
}

/// Whether a simulation with these settings takes them: the implicit flow has them.
pub(crate) fn is_sparse<S, const Q: usize, const N: usize, const R: usize>(
    settings: &Settings,
) -> bool
where
    S: System<Q, N, R>,
{
    let possible = const { is_large::<S, Q, N, R>() };
    possible
        && settings.method == Method::TwoLevel
        && settings.order == 2
        && settings.fixed_iterations.is_none()
        && matches!(settings.flow, None | Some(Flow::Implicit))
}
