//! The two-level ALF-3F integrator: the default.

use super::core::{Core, Counters};
use super::kicks;
use crate::flow::Leapfrog;
use crate::{Flow, Settings, SimulationError, State, System};

/// The integrator by itself: steps of any length, without energy balance or report.
///
/// A step allocates nothing. [`Simulation`](crate::Simulation) wraps it; use it directly to measure, or to compose steps.
pub struct TwoLevelStepper<S: System<N, R>, const N: usize, const R: usize> {
    pub(crate) core: Core<S, N, R>,
    flow: Flow,
    leapfrog: Leapfrog<N>,
}

impl<S: System<N, R>, const N: usize, const R: usize> TwoLevelStepper<S, N, R> {
    /// An integrator that starts from `state`, which has to satisfy the constraints.
    ///
    /// # Errors
    /// Settings that cannot be used, or a mass matrix that is not positive definite at the state.
    pub fn new(
        system: S,
        state: State<N, R>,
        settings: &Settings,
    ) -> Result<Self, SimulationError> {
        settings.check()?;
        let flow = crate::flow::choose(&system, &state, settings)?;
        let time = state.time;
        let core = Core::new(system, state, settings)
            .map_err(|fault| SimulationError::from_fault(fault, S::MODEL, time, settings.step))?;
        Ok(TwoLevelStepper {
            core,
            flow,
            leapfrog: Leapfrog::new(),
        })
    }

    /// One step of h seconds (negative: back in time).
    ///
    /// # Errors
    /// A row that does not converge, by name; a state that is not finite; a mass matrix that is not positive definite.
    /// The state is then still that before the step.
    #[inline]
    pub fn step(&mut self, h: f64) -> Result<(), SimulationError> {
        let result = match self.flow {
            Flow::Leapfrog => kicks::step(&mut self.core, &mut self.leapfrog, h),
            _ => todo!(),
        };
        result.map_err(|fault| {
            SimulationError::from_fault(fault, S::MODEL, self.core.state.time, h)
        })
    }

    /// The equations.
    pub fn system(&self) -> &S {
        &self.core.system
    }

    /// Where it stands.
    pub fn state(&self) -> &State<N, R> {
        &self.core.state
    }

    /// The flow in use.
    pub fn flow(&self) -> Flow {
        self.flow
    }

    pub(crate) fn counters(&self) -> Counters {
        self.core.counters
    }
}
