//! What a program compiles beside the two-level method, behind pointers to functions.
//!
//! A simulation with the two-level method alone has none of them: neither the other methods nor the choice between methods,
//! with its trials, are compiled for its mechanism.

use crate::stepper::MakeStepper;
use crate::{AssemblyVerdict, Settings, SimulationError, State, System};

/// The functions of a simulation for the methods that a type of [`methods`](crate::methods) names.
pub(super) struct OtherMethods<
    Simulation: 'static,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
> {
    /// Makes the stepper of a method; again where parameters change.
    pub(super) make: MakeStepper<S, Q, N, R>,
    /// Makes a simulation with the candidate for an accuracy that takes the least work from a state on, …
    pub(super) choose: Choose<Simulation, S, Q, N, R>,
    /// … and takes a pair of steps with a tolerance in the time that is left, s, with this candidate, or with another one if
    /// the motion has changed.
    pub(super) pair: fn(&mut Simulation, f64, f64) -> Result<(), SimulationError>,
}

type Choose<Simulation, S, const Q: usize, const N: usize, const R: usize> =
    fn(
        S,
        (Settings, f64),
        State<Q, N, R>,
        AssemblyVerdict,
        &'static OtherMethods<Simulation, S, Q, N, R>,
    ) -> Result<Simulation, SimulationError>;
