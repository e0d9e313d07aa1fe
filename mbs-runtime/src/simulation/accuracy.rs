//! A method for an accuracy ([`Settings::accuracy`](crate::Settings::accuracy)): each candidate runs the beginning of the
//! motion, and the one with the least operations for a second of it is taken.
//!
//! | candidate | where it has the least |
//! |---|---|
//! | two-level with a tolerance | free rotations, many rows, stiff dampers and springs |
//! | explicit, projected, with a tolerance | most others: no Newton iteration in its stages |
//!
//! Operations are counted, not timed, so that the choice is the same in every run.

use super::Simulation;
use crate::stepper::MakeStepper;
use crate::work::work;
use crate::{AssemblyVerdict, Method, Settings, SimulationError, State, System};

/// Errors of steps add up and grow with the motion's own instability: on the scenes with a reference the largest error was
/// up to 48 tolerances with steps of the projected method, and 29 with two-level ones.
const MARGIN: f64 = 0.125;
/// Pairs of steps that are counted, after the first length of steps was found.
const COUNTED: usize = 12;
/// How often they are counted anew while steps grow.
const WINDOWS: usize = 6;
/// Pairs that a candidate has for finding it.
const TRIED: usize = 60;

impl<S, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R>
where
    S: System<Q, N, R> + Clone,
{
    /// With the given method or, for an accuracy, with the candidate that takes the least work from this state on.
    pub(super) fn begin(
        system: S,
        settings: Settings,
        state: State<Q, N, R>,
        assembly: AssemblyVerdict,
        other: Option<MakeStepper<S, Q, N, R>>,
    ) -> Result<Self, SimulationError> {
        let Some(accuracy) = settings.accuracy else {
            return Self::from_state(system, settings, state, assembly, other);
        };
        let tolerance = (MARGIN * accuracy).max(Settings::LEAST_TOLERANCE);
        let two_level = Settings {
            accuracy: None,
            ..settings.with_tolerance(tolerance)
        };
        if other.is_none() {
            // There is nothing to choose from.
            return Self::from_state(system, two_level, state, assembly, None);
        }
        let projected = Settings {
            method: Method::Projected,
            order: 8,
            ..two_level
        };
        let make = |candidate: Settings| {
            let (system, state, assembly) = (system.clone(), state.clone(), assembly.clone());
            Self::from_state(system, candidate, state, assembly, other)
        };
        let mut best = (f64::INFINITY, two_level);
        for candidate in [two_level, projected] {
            // A candidate that cannot begin here is none.
            let Ok(mut trial) = make(candidate) else {
                continue;
            };
            let Ok(rate) = trial.rate_of_work() else {
                continue;
            };
            if rate < best.0 {
                let step = trial.nominal();
                best = (rate, Settings { step, ..candidate });
            }
        }
        make(best.1)
    }

    /// Operations for a second of the motion with the steps that the tolerance asks for.
    fn rate_of_work(&mut self) -> Result<f64, SimulationError> {
        for _ in 0..TRIED {
            if self.state().step_controller.step > 0.0 && !self.state().step_controller.eager {
                break;
            }
            self.forward(self.nominal(), f64::INFINITY)?;
        }
        // A transient at the start needs short steps: the count begins anew while they grow.
        let mut rate = f64::INFINITY;
        for _ in 0..WINDOWS {
            let step = self.nominal();
            rate = self.rate_over(COUNTED)?;
            if self.nominal() <= step {
                break;
            }
        }
        Ok(rate)
    }

    fn rate_over(&mut self, pairs: usize) -> Result<f64, SimulationError> {
        let (start, before) = (self.time(), self.report());
        for _ in 0..pairs {
            self.forward(self.nominal(), f64::INFINITY)?;
        }
        let done = self.report();
        let stages = done.stages - before.stages;
        let iterations = done.iterations - before.iterations;
        let plan = S::ELIMINATION.filter(|_| self.integrator.is_sparse());
        let planned = plan.map(|plan| plan.operations);
        let flow = self.flow();
        let operations = work(S::MODEL, &self.settings, flow, planned, stages, iterations);
        Ok(operations / (self.time() - start))
    }
}
