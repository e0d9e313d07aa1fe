//! Which mechanisms are large: their matrices are sparse.

use crate::{Flow, Method, Settings, SimulationError, System};

/// With fewer velocities and rows the dense arrays of the implicit flow, held in caches, are the faster …
const FEWEST_UNKNOWNS: usize = 60;
/// … without rows …
const FEWEST_WITHOUT_ROWS: usize = 150;
/// … and those of the other flows, which need no tangents.
const FEWEST_BESIDE_OTHERS: usize = 300;

/// With more velocities the matrices that the dense flows have on the stack, N × N, are larger than 4 MB.
const MOST_DENSE: usize = 700;

/// Whether there are sparse factors for a mechanism: it is large, and its elimination was not planned when it was
/// compiled. A constant of the mechanism: others do not compile the code for it.
pub(crate) const fn is_large<S, const Q: usize, const N: usize, const R: usize>() -> bool
where
    S: System<Q, N, R>,
{
    let fewest = match R {
        0 => FEWEST_WITHOUT_ROWS,
        _ => FEWEST_UNKNOWNS,
    };
    cfg!(feature = "sparse") && N + R >= fewest && S::ELIMINATION.is_none()
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
        && match settings.flow {
            None => S::STRUCTURE.velocity_forces || N + R >= FEWEST_BESIDE_OTHERS,
            flow => flow == Some(Flow::Implicit),
        }
}

/// Refuses dense arrays that would not fit on a stack.
pub(crate) fn check_dense(velocities: usize, flow: Flow) -> Result<(), SimulationError> {
    if flow == Flow::Leapfrog || velocities <= MOST_DENSE {
        return Ok(());
    }
    let wanted = match cfg!(feature = "sparse") {
        true => "the sparse ones are of order 2, with the implicit flow or the runtime's choice",
        false => "sparse ones come with the feature `sparse` of `mbs-runtime`",
    };
    Err(SimulationError::Large {
        velocities,
        flow,
        wanted,
    })
}
