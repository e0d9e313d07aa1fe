//! One interface for all integrators.

use crate::alf3f::{Counters, StepMonitor};
use crate::estimate::Estimate;
use crate::singular::RankMargin;
use crate::stepper::{AnyStepper, MakeStepper, Trace};
use crate::{Flow, Method, Settings, SimulationError, State, System, TwoLevelStepper};
use nalgebra::SVector;

/// The integrator of a simulation: the two-level method, or one that only some programs compile.
// One per simulation, and no box between a simulation and its usual method.
#[allow(clippy::large_enum_variant)]
#[derive(Clone)]
pub(crate) enum Integrator<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    TwoLevel(TwoLevelStepper<S, Q, N, R>),
    Other(AnyStepper<S, Q, N, R>),
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Integrator<S, Q, N, R> {
    /// With `other` for the methods other than the two-level one.
    pub(crate) fn new(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
        other: Option<MakeStepper<S, Q, N, R>>,
    ) -> Result<Self, SimulationError> {
        match (settings.method, other) {
            (Method::TwoLevel, _) => {
                let placed = settings.placement && settings.fixed_iterations.is_none();
                TwoLevelStepper::for_steps(system, state, settings, placed)
                    .map(Integrator::TwoLevel)
            }
            (_, Some(other)) => other(system, state, settings).map(Integrator::Other),
            (method, None) => Err(SimulationError::NotCompiled {
                method: method.name(),
            }),
        }
    }

    pub(crate) fn step(
        &mut self,
        h: f64,
        monitor: &mut StepMonitor,
    ) -> Result<(), SimulationError> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.pass(h, monitor),
            Integrator::Other(stepper) => stepper.step(h, monitor),
        }
    }

    /// The rank margin of the rows; `None` if there are no rows, or if the method does not compute
    /// it.
    pub(crate) fn rank_margin(&mut self) -> Option<RankMargin> {
        if const { S::STRUCTURE.holonomic_rows == 0 } {
            return None;
        }
        match self {
            Integrator::TwoLevel(stepper) => stepper.rank_margin(),
            Integrator::Other(stepper) => stepper.rank_margin(),
        }
    }

    /// See [`TwoLevelStepper::aim`].
    pub(crate) fn aim(&self, bounds: [f64; 2]) -> Option<(f64, f64)> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.aim(bounds),
            Integrator::Other(_) => None,
        }
    }

    /// How far the stages of an explicit step of this length, as a fraction of the last one, keep away from a singular pose;
    /// NaN if it is not known.
    pub(crate) fn expected_clearance(&self, length: f64) -> f64 {
        match self {
            Integrator::TwoLevel(_) => f64::NAN,
            Integrator::Other(stepper) => stepper.expected_clearance(length),
        }
    }

    /// A singular pose, or one that is nearly singular, that the stages of the last explicit step have seen within it, as a
    /// fraction of the step.
    pub(crate) fn pose_within(&self) -> Option<f64> {
        match self {
            Integrator::TwoLevel(_) => None,
            Integrator::Other(stepper) => stepper.pose_within(),
        }
    }

    /// The error of the last step by an embedded method; `None` without one.
    pub(crate) fn estimate(&self) -> Option<Estimate> {
        match self {
            Integrator::TwoLevel(stepper) => {
                let smooth = |error| Estimate::smooth(error, 0.0);
                stepper.estimate().map(smooth)
            }
            Integrator::Other(stepper) => stepper.estimate(),
        }
    }

    /// Whether its elimination is planned.
    pub(crate) fn is_sparse(&self) -> bool {
        match self {
            Integrator::TwoLevel(stepper) => stepper.is_sparse(),
            Integrator::Other(stepper) => stepper.is_sparse(),
        }
    }

    /// The weight of each row in the combination that is nearest to dependence.
    pub(crate) fn weakest_rows(&mut self) -> SVector<f64, R> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.weakest_rows(),
            Integrator::Other(stepper) => stepper.weakest_rows(),
        }
    }

    pub(crate) fn system(&self) -> &S {
        match self {
            Integrator::TwoLevel(stepper) => &stepper.context.system,
            Integrator::Other(stepper) => stepper.system(),
        }
    }

    pub(crate) fn system_mut(&mut self) -> &mut S {
        match self {
            Integrator::TwoLevel(stepper) => &mut stepper.context.system,
            Integrator::Other(stepper) => stepper.system_mut(),
        }
    }

    pub(crate) fn state(&self) -> &State<Q, N, R> {
        match self {
            Integrator::TwoLevel(stepper) => &stepper.context.state,
            Integrator::Other(stepper) => stepper.state(),
        }
    }

    pub(crate) fn state_mut(&mut self) -> &mut State<Q, N, R> {
        match self {
            Integrator::TwoLevel(stepper) => &mut stepper.context.state,
            Integrator::Other(stepper) => stepper.state_mut(),
        }
    }

    /// Notes the inputs of the system in the state.
    pub(crate) fn note_inputs(&mut self) {
        let mut inputs = std::mem::take(&mut self.state_mut().inputs);
        inputs.clear();
        inputs.extend_from_slice(self.system().inputs());
        self.state_mut().inputs = inputs;
    }

    /// To be called after the state or an input was changed.
    pub(crate) fn refresh(&mut self, settings: &Settings) -> Result<(), SimulationError> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.refresh(),
            Integrator::Other(stepper) => stepper.refresh(),
        }
        .map_err(|fault| {
            SimulationError::from_fault(fault, S::MODEL, self.state().time, settings.step)
        })
    }

    /// Results of the last accepted step.
    pub(crate) fn trace(&self) -> Trace<'_, Q, N, R> {
        match self {
            Integrator::TwoLevel(stepper) => {
                let context = &stepper.context;
                Trace {
                    phi: &context.work.phi,
                    rates: stepper.rates(),
                }
            }
            Integrator::Other(stepper) => stepper.trace(),
        }
    }

    /// See [`Simulation::step_multipliers`](crate::Simulation::step_multipliers).
    pub(crate) fn multipliers(&self) -> Option<SVector<f64, R>> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.multipliers(),
            Integrator::Other(stepper) => stepper.multipliers(),
        }
    }

    pub(crate) fn flow(&self) -> Flow {
        match self {
            Integrator::TwoLevel(stepper) => stepper.flow(),
            Integrator::Other(stepper) => stepper.flow(),
        }
    }

    pub(crate) fn counters(&self) -> Counters {
        match self {
            Integrator::TwoLevel(stepper) => stepper.counters(),
            Integrator::Other(stepper) => stepper.counters(),
        }
    }
}
