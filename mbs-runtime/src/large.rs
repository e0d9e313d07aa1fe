//! Which mechanisms are large: their matrices are sparse.

use crate::generated::Elimination;
use crate::{Flow, Method, Settings, SimulationError, System};

/// With fewer velocities and rows the dense arrays of the implicit flow, held in caches, are the faster …
const FEWEST_UNKNOWNS: usize = 60;
/// … without rows …
const FEWEST_WITHOUT_ROWS: usize = 150;
/// … and those of the other flows, which need no tangents.
const FEWEST_BESIDE_OTHERS: usize = 300;

/// With more velocities the matrices that the dense flows have on the stack, N × N, are larger than 4 MB.
const MOST_DENSE: usize = 700;

/// Whether there are sparse factors for a mechanism: it is large. A constant of the mechanism: others do not compile the code for it.
pub(crate) const fn is_large<const N: usize, const R: usize>() -> bool {
    let fewest = match R {
        0 => FEWEST_WITHOUT_ROWS,
        _ => FEWEST_UNKNOWNS,
    };
    cfg!(feature = "sparse") && N + R >= fewest
}

/// Whether a simulation with these settings takes them: the implicit flow has them. If the elimination was planned when
/// the mechanism was compiled, that flow has to be asked for.
pub(crate) fn is_sparse<S, const Q: usize, const N: usize, const R: usize>(
    settings: &Settings,
) -> bool
where
    S: System<Q, N, R>,
{
    may_be_sparse::<N, R>(settings)
        && match settings.flow {
            None if kick_elimination::<S, Q, N, R>().is_some() => false,
            None => S::STRUCTURE.velocity_forces || is_beside_others::<N, R>(),
            flow => flow == Some(Flow::Implicit),
        }
}

/// Whether steps with these settings could take them if their flow is the implicit one.
pub(crate) fn may_be_sparse<const N: usize, const R: usize>(settings: &Settings) -> bool {
    let possible = const { is_large::<N, R>() };
    possible
        && settings.method == Method::TwoLevel
        && settings.order == 2
        && settings.fixed_iterations.is_none()
}

/// The elimination of a mechanism whose kicks were planned when it was compiled, too.
pub(crate) const fn kick_elimination<S, const Q: usize, const N: usize, const R: usize>()
-> Option<&'static Elimination<N, R>>
where
    S: System<Q, N, R>,
{
    match S::ELIMINATION {
        Some(plan) if plan.kicks.is_some() => Some(plan),
        _ => None,
    }
}

/// Whether the start of a mechanism is computed without dense arrays, if there are factors for it: those of an elimination
/// that was planned when the mechanism was compiled, or those of the sparse implicit flow.
pub(crate) const fn starts_sparse<const N: usize, const R: usize>() -> bool {
    cfg!(feature = "std") && is_beside_others::<N, R>()
}

/// Whether a mechanism is so large that dense arrays are the slower ones, also for flows that need no tangents.
pub(crate) const fn is_beside_others<const N: usize, const R: usize>() -> bool {
    N + R >= FEWEST_BESIDE_OTHERS
}

/// Refuses dense arrays that would not fit on a stack.
pub(crate) fn check_dense(velocities: usize, flow: Flow) -> Result<(), SimulationError> {
    match flow == Flow::Leapfrog || velocities <= MOST_DENSE {
        true => Ok(()),
        false => Err(too_large(velocities, flow)),
    }
}

/// The same for a start: A and A M⁻¹ Aᵀ.
#[cfg(feature = "std")]
pub(crate) fn check_dense_start(velocities: usize, rows: usize) -> Result<(), SimulationError> {
    match rows * (velocities + rows) <= MOST_DENSE * MOST_DENSE {
        true => Ok(()),
        false => Err(SimulationError::Large {
            velocities,
            flow: None,
            wanted: "declare values that are held as guesses, or make the mechanism smaller",
        }),
    }
}

fn too_large(velocities: usize, flow: Flow) -> SimulationError {
    let flow = Some(flow);
    let wanted = match cfg!(feature = "sparse") {
        true => "the sparse ones are of order 2, with the implicit flow or the runtime's choice",
        false => "sparse ones come with the feature `sparse` of `mbs-runtime`",
    };
    SimulationError::Large {
        velocities,
        flow,
        wanted,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A start on such arrays would overflow the stack of a program, which nothing reports.
    #[test]
    fn a_start_that_is_too_large_is_refused() {
        assert_eq!(check_dense_start(400, 400), Ok(()));
        assert_eq!(check_dense_start(3000, 0), Ok(()));
        let refused = check_dense_start(1201, 600);
        assert!(
            matches!(
                refused,
                Err(SimulationError::Large {
                    velocities: 1201,
                    ..
                })
            ),
            "{refused:?}"
        );
    }
}
