//! What a program compiles beside the two-level method, behind pointers to functions.
//!
//! A simulation with the two-level method alone has none of them: neither the other methods nor the choice between methods,
//! with its trials, are compiled for its mechanism.

use super::Simulation;
use crate::methods::Methods;
use crate::stepper::MakeStepper;
use crate::{AssemblyVerdict, Settings, SimulationError, State, System};

/// A simulation with the candidate for an accuracy that takes the least work from a state on.
type Choose<S, const Q: usize, const N: usize, const R: usize> =
    fn(
        S,
        (Settings, f64),
        State<Q, N, R>,
        AssemblyVerdict,
        &'static OtherMethods<S, Q, N, R>,
    ) -> Result<Simulation<S, Q, N, R>, SimulationError>;

/// A pair of steps with a tolerance in the time that is left, s.
type Pair<S, const Q: usize, const N: usize, const R: usize> =
    fn(&mut Simulation<S, Q, N, R>, f64, f64) -> Result<(), SimulationError>;

/// The functions for the methods that a type of [`methods`](crate::methods) names.
pub(crate) struct OtherMethods<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    /// Makes the stepper of a method; again where parameters change.
    pub(crate) make: MakeStepper<S, Q, N, R>,
    /// Chooses a method for an accuracy, …
    pub(super) choose: Choose<S, Q, N, R>,
    /// … and takes a pair of steps with it, or with another one if the motion has changed.
    pub(super) pair: Pair<S, Q, N, R>,
}

impl<S, const Q: usize, const N: usize, const R: usize> OtherMethods<S, Q, N, R>
where
    S: System<Q, N, R> + Clone,
{
    /// Those of `C`.
    pub(super) fn of<C: Methods>(_: C) -> Option<&'static Self> {
        const {
            Some(&OtherMethods {
                make: C::make,
                choose: Simulation::chosen,
                pair: Simulation::chosen_pair,
            })
        }
    }
}
