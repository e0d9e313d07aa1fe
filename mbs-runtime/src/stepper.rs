//! The methods other than the two-level one behind one object-safe trait.
//!
//! A simulation calls them through a table of functions, which only the types of [`methods`](crate::methods) fill: a
//! program that does not name a method there does not compile it.

use crate::alf3f::{Counters, PaperStepper, StepMonitor};
use crate::estimate::Estimate;
use crate::fault::Fault;
use crate::singular::RankMargin;
use crate::{BaselineStepper, Flow, Settings, SimulationError, State, System};
use nalgebra::SVector;

/// A method as a simulation uses it; the functions are those of the enumeration `Integrator`.
pub(crate) trait Stepper<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>:
    BoxedStepper<S, Q, N, R> + Send + Sync
{
    fn step(&mut self, h: f64, monitor: &mut StepMonitor) -> Result<(), SimulationError>;
    fn rank_margin(&mut self) -> Option<RankMargin>;
    fn weakest_rows(&mut self) -> SVector<f64, R>;
    fn system(&self) -> &S;
    fn system_mut(&mut self) -> &mut S;
    fn state(&self) -> &State<Q, N, R>;
    fn state_mut(&mut self) -> &mut State<Q, N, R>;
    fn refresh(&mut self) -> Result<(), Fault>;
    fn trace(&self) -> Trace<'_, Q, N, R>;
    fn multipliers(&self) -> Option<SVector<f64, R>>;
    fn flow(&self) -> Flow;
    fn counters(&self) -> Counters;
    fn is_sparse(&self) -> bool;
    fn estimate(&self) -> Option<Estimate>;
    fn expected_clearance(&self, length: f64) -> f64;
    fn pose_within(&self) -> Option<f64>;
}

/// A copy of a method behind a box; every method that can be cloned has it.
pub(crate) trait BoxedStepper<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    /// The method and its workspace again.
    fn boxed_clone(&self) -> AnyStepper<S, Q, N, R>;
}

impl<T, S, const Q: usize, const N: usize, const R: usize> BoxedStepper<S, Q, N, R> for T
where
    T: Stepper<S, Q, N, R> + Clone + 'static,
    S: System<Q, N, R>,
{
    fn boxed_clone(&self) -> AnyStepper<S, Q, N, R> {
        Box::new(self.clone())
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Clone
    for AnyStepper<S, Q, N, R>
{
    fn clone(&self) -> Self {
        self.as_ref().boxed_clone()
    }
}

/// Quantities after a step, for the report.
pub(crate) struct Trace<'a, const Q: usize, const N: usize, const R: usize> {
    /// φ.
    pub(crate) phi: &'a SVector<f64, R>,
    /// A v + b.
    pub(crate) rates: SVector<f64, R>,
}

/// A boxed method.
pub(crate) type AnyStepper<S, const Q: usize, const N: usize, const R: usize> =
    Box<dyn Stepper<S, Q, N, R>>;

/// Makes the stepper of a method other than the two-level one.
pub(crate) type MakeStepper<S, const Q: usize, const N: usize, const R: usize> =
    fn(S, State<Q, N, R>, &Settings) -> Result<AnyStepper<S, Q, N, R>, SimulationError>;

impl<S, const Q: usize, const N: usize, const R: usize> Stepper<S, Q, N, R>
    for PaperStepper<S, Q, N, R>
where
    S: System<Q, N, R>,
{
    fn step(&mut self, h: f64, monitor: &mut StepMonitor) -> Result<(), SimulationError> {
        PaperStepper::step(self, h)?;
        let State {
            time,
            positions,
            velocities,
            ..
        } = &self.state;
        let power = self
            .system
            .nonconservative_power(*time, positions, velocities);
        monitor.nonconservative_work += 0.5 * h * (monitor.power + power);
        monitor.power = power;
        monitor.drive_work += self.drive().iter().sum::<f64>();
        Ok(())
    }

    fn rank_margin(&mut self) -> Option<RankMargin> {
        None
    }

    fn weakest_rows(&mut self) -> SVector<f64, R> {
        SVector::zeros()
    }

    fn system(&self) -> &S {
        &self.system
    }

    fn system_mut(&mut self) -> &mut S {
        &mut self.system
    }

    fn state(&self) -> &State<Q, N, R> {
        &self.state
    }

    fn state_mut(&mut self) -> &mut State<Q, N, R> {
        &mut self.state
    }

    fn refresh(&mut self) -> Result<(), Fault> {
        PaperStepper::refresh(self)
    }

    fn trace(&self) -> Trace<'_, Q, N, R> {
        Trace {
            phi: self.phi(),
            rates: self.rates(),
        }
    }

    fn multipliers(&self) -> Option<SVector<f64, R>> {
        PaperStepper::multipliers(self)
    }

    /// It uses the trapezoidal rule, with the multipliers among its unknowns.
    fn flow(&self) -> Flow {
        Flow::Implicit
    }

    fn counters(&self) -> Counters {
        PaperStepper::counters(self)
    }

    fn is_sparse(&self) -> bool {
        false
    }

    fn estimate(&self) -> Option<Estimate> {
        None
    }

    fn expected_clearance(&self, _length: f64) -> f64 {
        f64::NAN
    }

    fn pose_within(&self) -> Option<f64> {
        None
    }
}

impl<S, const Q: usize, const N: usize, const R: usize> Stepper<S, Q, N, R>
    for BaselineStepper<S, Q, N, R>
where
    S: System<Q, N, R>,
{
    fn step(&mut self, h: f64, monitor: &mut StepMonitor) -> Result<(), SimulationError> {
        BaselineStepper::step(self, h)?;
        let works = self.take_stock()?;
        monitor.nonconservative_work += works.nonconservative;
        monitor.drive_work += works.drive;
        if monitor.rank_margin.is_some() {
            monitor.rank_margin = BaselineStepper::rank_margin(self);
            monitor.clearance = monitor.clearance.min(self.clearance());
        }
        Ok(())
    }

    fn rank_margin(&mut self) -> Option<RankMargin> {
        BaselineStepper::rank_margin(self)
    }

    fn weakest_rows(&mut self) -> SVector<f64, R> {
        BaselineStepper::weakest_rows(self)
    }

    fn system(&self) -> &S {
        &self.bench.system
    }

    fn system_mut(&mut self) -> &mut S {
        &mut self.bench.system
    }

    fn state(&self) -> &State<Q, N, R> {
        &self.bench.state
    }

    fn state_mut(&mut self) -> &mut State<Q, N, R> {
        &mut self.bench.state
    }

    fn refresh(&mut self) -> Result<(), Fault> {
        BaselineStepper::refresh(self)
    }

    fn trace(&self) -> Trace<'_, Q, N, R> {
        let bench = &self.bench;
        Trace {
            phi: &bench.phi,
            rates: bench.velocity_rows(),
        }
    }

    fn multipliers(&self) -> Option<SVector<f64, R>> {
        BaselineStepper::multipliers(self)
    }

    /// They have no flow between kicks.
    fn flow(&self) -> Flow {
        Flow::Leapfrog
    }

    fn counters(&self) -> Counters {
        BaselineStepper::counters(self)
    }

    fn is_sparse(&self) -> bool {
        BaselineStepper::is_sparse(self)
    }

    fn estimate(&self) -> Option<Estimate> {
        BaselineStepper::estimate(self)
    }

    fn expected_clearance(&self, length: f64) -> f64 {
        BaselineStepper::expected_clearance(self, length)
    }

    fn pose_within(&self) -> Option<f64> {
        BaselineStepper::pose_within(self)
    }
}
