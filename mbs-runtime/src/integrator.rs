//! One interface for all integrators.

use crate::alf3f::{Counters, PaperStepper, StepMonitor};
use crate::singular::RankMargin;
use crate::{
    BaselineStepper, Flow, Method, Settings, SimulationError, State, System, TwoLevelStepper,
};
use nalgebra::SVector;

/// The integrator of a simulation.
pub(crate) enum Integrator<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    TwoLevel(TwoLevelStepper<S, Q, N, R>),
    Paper(PaperStepper<S, Q, N, R>),
    Baseline(BaselineStepper<S, Q, N, R>),
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Integrator<S, Q, N, R> {
    pub(crate) fn new(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<Self, SimulationError> {
        match settings.method {
            Method::TwoLevel => {
                let placed = settings.placement && settings.fixed_iterations.is_none();
                TwoLevelStepper::for_steps(system, state, settings, placed)
                    .map(Integrator::TwoLevel)
            }
            Method::Paper(_) | Method::MAlf(_) => {
                PaperStepper::new(system, state, settings).map(Integrator::Paper)
            }
            _ => BaselineStepper::new(system, state, settings).map(Integrator::Baseline),
        }
    }

    pub(crate) fn step(
        &mut self,
        h: f64,
        monitor: &mut StepMonitor,
    ) -> Result<(), SimulationError> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.pass(h, monitor),
            Integrator::Paper(stepper) => {
                stepper.step(h)?;
                let State {
                    time,
                    positions,
                    velocities,
                    ..
                } = stepper.state();
                let power = stepper
                    .system
                    .nonconservative_power(*time, positions, velocities);
                monitor.nonconservative_work += 0.5 * h * (monitor.power + power);
                monitor.power = power;
                monitor.drive_work += stepper.drive().iter().sum::<f64>();
                Ok(())
            }
            Integrator::Baseline(stepper) => {
                stepper.step(h)?;
                let works = stepper.take_stock()?;
                monitor.nonconservative_work += works.nonconservative;
                monitor.drive_work += works.drive;
                if monitor.rank_margin.is_some() {
                    monitor.rank_margin = stepper.rank_margin();
                    monitor.clearance = monitor.clearance.min(stepper.clearance());
                }
                Ok(())
            }
        }
    }

    /// The rank margin of the rows; `None` if there are no rows, or if the method does not compute
    /// it.
    pub(crate) fn rank_margin(&mut self) -> Option<RankMargin> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.rank_margin(),
            Integrator::Baseline(stepper) => stepper.rank_margin(),
            Integrator::Paper(_) => None,
        }
    }

    /// See [`TwoLevelStepper::aim`].
    pub(crate) fn aim(&self, bounds: [f64; 2]) -> Option<(f64, f64)> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.aim(bounds),
            _ => None,
        }
    }

    /// The weight of each row in the combination that is nearest to dependence.
    pub(crate) fn weakest_rows(&mut self) -> SVector<f64, R> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.weakest_rows(),
            Integrator::Baseline(stepper) => stepper.weakest_rows(),
            Integrator::Paper(_) => SVector::zeros(),
        }
    }

    pub(crate) fn system(&self) -> &S {
        match self {
            Integrator::TwoLevel(stepper) => &stepper.context.system,
            Integrator::Paper(stepper) => &stepper.system,
            Integrator::Baseline(stepper) => &stepper.bench.system,
        }
    }

    pub(crate) fn system_mut(&mut self) -> &mut S {
        match self {
            Integrator::TwoLevel(stepper) => &mut stepper.context.system,
            Integrator::Paper(stepper) => &mut stepper.system,
            Integrator::Baseline(stepper) => &mut stepper.bench.system,
        }
    }

    pub(crate) fn state(&self) -> &State<Q, N, R> {
        match self {
            Integrator::TwoLevel(stepper) => &stepper.context.state,
            Integrator::Paper(stepper) => &stepper.state,
            Integrator::Baseline(stepper) => &stepper.bench.state,
        }
    }

    pub(crate) fn state_mut(&mut self) -> &mut State<Q, N, R> {
        match self {
            Integrator::TwoLevel(stepper) => &mut stepper.context.state,
            Integrator::Paper(stepper) => &mut stepper.state,
            Integrator::Baseline(stepper) => &mut stepper.bench.state,
        }
    }

    /// To be called after the state or an input was changed.
    pub(crate) fn refresh(&mut self, settings: &Settings) -> Result<(), SimulationError> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.refresh(),
            Integrator::Paper(stepper) => stepper.refresh(),
            Integrator::Baseline(stepper) => stepper.refresh(),
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
            Integrator::Paper(stepper) => Trace {
                phi: stepper.phi(),
                rates: stepper.rates(),
            },
            Integrator::Baseline(stepper) => {
                let bench = &stepper.bench;
                Trace {
                    phi: &bench.phi,
                    rates: bench
                        .geometry
                        .velocity_rows(&bench.system, &bench.state.velocities),
                }
            }
        }
    }

    /// See [`Simulation::step_multipliers`](crate::Simulation::step_multipliers).
    pub(crate) fn multipliers(&self) -> Option<SVector<f64, R>> {
        match self {
            Integrator::TwoLevel(stepper) => stepper.multipliers(),
            Integrator::Paper(stepper) => stepper.multipliers(),
            Integrator::Baseline(stepper) => stepper.multipliers(),
        }
    }

    pub(crate) fn flow(&self) -> Flow {
        match self {
            Integrator::TwoLevel(stepper) => stepper.flow(),
            // It uses the trapezoidal rule, with the multipliers among its unknowns.
            Integrator::Paper(_) => Flow::Implicit,
            // They have no flow between kicks.
            Integrator::Baseline(_) => Flow::Leapfrog,
        }
    }

    pub(crate) fn counters(&self) -> Counters {
        match self {
            Integrator::TwoLevel(stepper) => stepper.counters(),
            Integrator::Paper(stepper) => stepper.counters(),
            Integrator::Baseline(stepper) => stepper.counters(),
        }
    }
}

/// Quantities after a step, for the report.
pub(crate) struct Trace<'a, const Q: usize, const N: usize, const R: usize> {
    /// φ.
    pub(crate) phi: &'a SVector<f64, R>,
    /// A v + b.
    pub(crate) rates: SVector<f64, R>,
}
