//! The messages to the page about failed calls.

use crate::figure::STEPS;
use mbs_runtime::SimulationError;
use std::fmt;

/// The reason why a call failed.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// There is no mechanism of this index.
    Mechanism(usize),
    /// There is no method of this index.
    Method(usize),
    /// There is no run of this index, or it was not started.
    Run(usize),
    /// A step out of range, s.
    Step(f64),
    /// The runtime refused the parameters, or could not take a step.
    Simulation(SimulationError),
}

impl fmt::Display for Refusal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [least, most] = STEPS;
        match self {
            Refusal::Mechanism(index) => {
                write!(out, "there is no mechanism {index}; reload the page")
            }
            Refusal::Method(index) => write!(out, "there is no method {index}; reload the page"),
            Refusal::Run(index) => write!(out, "run {index} was not started; reload the page"),
            Refusal::Step(step) => write!(
                out,
                "the step cannot be {step} s here; give it a value from {least} s to {most} s"
            ),
            Refusal::Simulation(error) => error.fmt(out),
        }
    }
}

impl std::error::Error for Refusal {}

impl From<SimulationError> for Refusal {
    fn from(error: SimulationError) -> Self {
        Refusal::Simulation(error)
    }
}
