//! What a program compiles beside the two-level method, behind pointers to functions.
//!
//! A simulation with the two-level method alone has none of them: neither the other methods nor the choice between methods,
//! with its trials, are compiled for its mechanism.

use crate::stepper::MakeStepper;
use crate::{AssemblyVerdict, Settings, SimulationError, State, System};

/// The functions of a simulation, `Run`, for the methods that a type of [`methods`](crate::methods) names.
pub(super) struct OtherMethods<
    Run: 'static,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
> {
    /// Makes the stepper of a method; again where parameters change.
    pub(super) make: MakeStepper<S, Q, N, R>,
    /// Makes a simulation with the candidate for an accuracy that takes the least work from a state on.
    pub(super) choose: Choose<Run, S, Q, N, R>,
    /// Takes a pair of steps with a tolerance, at most so many seconds, and changes the candidate if the motion has changed.
    pub(super) pair: fn(&mut Run, f64, f64) -> Result<(), SimulationError>,
}

type Choose<Run, S, const Q: usize, const N: usize, const R: usize> =
    fn(
        S,
        (Settings, f64),
        State<Q, N, R>,
        AssemblyVerdict,
        &'static OtherMethods<Run, S, Q, N, R>,
    ) -> Result<Run, SimulationError>;
