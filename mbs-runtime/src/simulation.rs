//! A mechanism in motion.

mod access;
mod accuracy;
mod advance;
mod any;
mod begin;
mod books;
mod choice;
mod comparison;
mod debug;
mod dense;
mod drives;
mod energy_guard;
mod fixed_steps;
mod hermite;
mod imbalance;
mod jumps;
mod known_poses;
mod lone_step;
mod names;
mod other_methods;
mod parameters;
mod passage;
mod placement;
mod pose;
mod refused;
mod revision;
mod run;
mod singularity_detector;
mod start;
mod state_errors;
mod state_values;
mod step_controller;
mod tolerance;
mod trial;

use self::books::Books;
use self::choice::Choice;
use self::energy_guard::EnergyGuard;
use self::other_methods::OtherMethods;
use self::refused::Refused;
use self::singularity_detector::SingularityDetector;
use crate::alf3f::Counters;
use crate::fault::Fault;
use crate::integrator::Integrator;
use crate::linear::largest;
use crate::methods::{self, Methods};
use crate::singular::RankMargin;
use crate::yardstick::Yardstick;
use crate::{
    AssemblyVerdict, Dynamics, Energy, Flow, Mechanism, Model, PosesAhead, RankLoss, Reactions,
    Report, Sample, Samples, Settings, SimulationError, State, System,
};
use nalgebra::SVector;

pub use self::access::InputsMut;
pub use self::start::Start;

/// A mechanism with its integrator: Q coordinates, N velocities, R constraint rows.
///
/// ```text
/// let mut simulation = Simulation::new(SliderCrank { crank_length: 0.2, ..Default::default() })?;
/// simulation.run_until(10.0)?;
/// ```
#[derive(Clone)]
pub struct Simulation<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    settings: Settings,
    integrator: Integrator<S, Q, N, R>,
    /// The methods that are compiled beside the two-level one.
    other: Option<&'static OtherMethods<Self, S, Q, N, R>>,
    /// For an accuracy: the candidates, and what is known about the one in use.
    choice: Option<Box<Choice>>,
    assembly: AssemblyVerdict,
    books: Books,
    /// The work of integrators that other parameters have replaced.
    counted: Counters,
    /// Steps that were repeated with a shorter one.
    rejected: u64,
    /// Steps whose length was changed beside a singular pose.
    placed: u64,
    /// The rank margin of the rows at the current state, if the last step computed it; otherwise the next step computes
    /// it.
    rank_margin: Option<RankMargin>,
    /// What [`Simulation::step_multipliers`] answers in place of the integrator: after a look at other instants the multipliers of
    /// the last step, after a failure `None`.
    multipliers_before: Option<Option<SVector<f64, R>>>,
    /// The energy balance after the last step.
    balance: Energy,
    energy_guard: EnergyGuard,
    /// Singular poses passed.
    singularities: SingularityDetector,
    /// Where the step that is being tried begins, …
    step_start: Box<State<Q, N, R>>,
    /// … the books there, …
    books_at_step_start: Books,
    /// … and what was known of poses ahead.
    poses_at_step_start: PosesAhead,
    /// Where the last whole step began, for `look_at`; its time is infinite if there is none.
    last_step_start: Box<State<Q, N, R>>,
    /// Where the pair of steps that is looked at begins, …
    pair_start: Box<State<Q, N, R>>,
    /// … and its end, while other steps are taken.
    pair_end: Box<State<Q, N, R>>,
    yardstick: Box<Yardstick<Q, N>>,
    /// Whether the method estimates the errors of its steps. No embedded method sees states.
    is_estimated: bool,
    /// How often parameters were changed: equations that were made before have the old ones.
    revision: u32,
    /// The last inputs, if they were refused, until a step has returned the error.
    refused: Option<Refused<S::Inputs>>,
    /// Values of the `Event`s; stored, so that the search for an event does not allocate.
    events: Vec<f64>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// A simulation with default settings, assembled from the declared guess: steps of a millisecond with the two-level method
    /// of order 2, as a control loop takes them. ([`Simulation::with_accuracy`] chooses method, order and steps.)
    ///
    /// # Errors
    /// Parameters that do not make a mechanism, or a guess that cannot be assembled.
    pub fn new<M: Mechanism<System = S>>(mechanism: M) -> Result<Self, SimulationError> {
        Self::with_settings(mechanism, Settings::default())
    }

    /// A simulation with the given settings, assembled from the declared guess.
    ///
    /// # Errors
    /// As [`Simulation::new`], and settings that cannot be used. For a method other than the two-level one it is
    /// [`SimulationError::NotCompiled`]: [`Simulation::with_methods`] accepts it.
    pub fn with_settings<M: Mechanism<System = S>>(
        mechanism: M,
        settings: Settings,
    ) -> Result<Self, SimulationError> {
        Self::assembled::<M, false>(mechanism, settings, &[], None)
    }

    /// The same with methods beside the two-level one, which a value of [`methods`] names: only these are compiled for
    /// this mechanism.
    ///
    /// # Errors
    /// As [`Simulation::new`], settings that cannot be used, a method that is not among these, and one that cannot integrate
    /// this mechanism.
    pub fn with_methods<M: Mechanism<System = S>, C: Methods>(
        mechanism: M,
        settings: Settings,
        _: C,
    ) -> Result<Self, SimulationError> {
        Self::assembled::<M, false>(mechanism, settings, &[], Self::other_methods::<C>())
    }

    /// The same for any [`Method`](crate::Method). All of them are then compiled for this mechanism, which takes longer
    /// than the two-level method alone by the factor that the book measures ("Compile times").
    ///
    /// # Errors
    /// As [`Simulation::with_methods`].
    pub fn with_any_method<M: Mechanism<System = S>>(
        mechanism: M,
        settings: Settings,
    ) -> Result<Self, SimulationError> {
        Self::with_methods(mechanism, settings, methods::Any)
    }

    /// One number instead of settings: the largest error of a position over the run, in sizes of the mechanism and radians
    /// ([`Settings::accuracy`]). Compiles the candidates: the two-level method and those of [`methods::Accuracy`].
    ///
    /// # Errors
    /// As [`Simulation::new`], and an accuracy that is not between 1e-11 and 0.1.
    pub fn with_accuracy<M: Mechanism<System = S>>(
        mechanism: M,
        accuracy: f64,
    ) -> Result<Self, SimulationError> {
        Self::with_methods(mechanism, Settings::accuracy(accuracy), methods::Accuracy)
    }

    /// A simulation that continues from a state, with its inputs: bit for bit if mechanism and settings are the same.
    ///
    /// # Errors
    /// As [`Simulation::with_settings`], and a state that is not finite, has inputs of another mechanism, or violates a row by more than
    /// a millionth of the size of the mechanism or the constraint tolerance. Methods that leave residuals of their own
    /// (Algorithm 1, M-ALF, penalties, Baumgarte's terms, BDF, and generalized α in the rates) take up to a hundredth.
    pub fn resume<M: Mechanism<System = S>>(
        mechanism: M,
        settings: Settings,
        state: State<Q, N, R>,
    ) -> Result<Self, SimulationError> {
        Self::resumed(mechanism, settings, state, None)
    }

    /// The same with methods beside the two-level one, if they have no memory besides the state; those that do
    /// begin anew ([`Method`](crate::Method) says which).
    ///
    /// # Errors
    /// As [`Simulation::with_methods`] and [`Simulation::resume`].
    pub fn resume_with_methods<M: Mechanism<System = S>, C: Methods>(
        mechanism: M,
        settings: Settings,
        state: State<Q, N, R>,
        _: C,
    ) -> Result<Self, SimulationError> {
        Self::resumed(mechanism, settings, state, Self::other_methods::<C>())
    }

    /// The same for any [`Method`](crate::Method).
    ///
    /// # Errors
    /// As [`Simulation::resume_with_methods`].
    pub fn resume_with_any_method<M: Mechanism<System = S>>(
        mechanism: M,
        settings: Settings,
        state: State<Q, N, R>,
    ) -> Result<Self, SimulationError> {
        Self::resume_with_methods(mechanism, settings, state, methods::Any)
    }

    /// What was modelled.
    pub fn model(&self) -> &'static Model {
        S::MODEL
    }

    /// The settings of the method in use. With an [accuracy](Settings::accuracy) they are those of the method that was chosen
    /// last: its name, order and tolerance, and no accuracy.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The flow in use.
    pub fn flow(&self) -> Flow {
        self.integrator.flow()
    }

    /// The equations.
    pub fn system(&self) -> &S {
        self.integrator.system()
    }

    /// The current state; [`Simulation::resume`] continues from it.
    pub fn state(&self) -> &State<Q, N, R> {
        self.integrator.state()
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        self.state().time
    }

    /// q, in the order and units of [`Model::coordinates`].
    pub fn positions(&self) -> &SVector<f64, Q> {
        &self.state().positions
    }

    /// v, in the order and units of [`Model::velocities`].
    pub fn velocities(&self) -> &SVector<f64, N> {
        &self.state().velocities
    }

    /// One step of [`Settings::step`], or of another length beside singular poses and where it would leap over a turn of the motion
    /// ([`Settings::placement`]; off, all steps have their length). With a tolerance one or two steps of the length that it determines.
    ///
    /// # Errors
    /// A row that does not converge, even with much smaller steps, or a state that is not finite; the message names the
    /// row and the time. The state is then that before the step; runs that end with such an error keep the steps before it.
    pub fn step(&mut self) -> Result<(), SimulationError> {
        self.check_inputs()?;
        // `look_at` shows the last step of `run_past` alone.
        self.last_step_start.time = f64::INFINITY;
        self.forward(self.nominal(), f64::INFINITY)
    }

    /// Samples at the current instant and every `interval` seconds up to `until`, simulating in between.
    pub fn samples(&mut self, until: f64, interval: f64) -> Samples<'_> {
        Samples::new(self, until, interval)
    }

    /// Named points in world axes, m, in the order of [`Model::points`].
    pub fn points(&self) -> Vec<[f64; 3]> {
        let mut points = vec![[0.0; 3]; S::MODEL.points.len()];
        self.system()
            .points(self.time(), self.positions(), &mut points);
        points
    }

    /// The energy balance.
    pub fn energy(&self) -> Energy {
        crate::energy::balance(self.system(), self.state())
    }

    /// The equations of motion at the current instant as matrices; [`Dynamics::evaluate`] moves them to any other state.
    ///
    /// # Errors
    /// A mass matrix that is not positive definite, or rows that admit no finite multiplier.
    pub fn dynamics(&self) -> Result<Dynamics<S, Q, N, R>, SimulationError> {
        let system = self.system().clone();
        let mut dynamics = Dynamics::new(system, self.time(), self.positions(), self.velocities())?;
        dynamics.revision = self.revision;
        Ok(dynamics)
    }

    /// Moves equations that [`Simulation::dynamics`] of this simulation has made to the current instant, with the current inputs
    /// and parameters. Allocates nothing, except after parameters were changed:
    ///
    /// ```
    /// # use mbs_runtime::{Simulation, mechanism};
    /// # mechanism!(Pendulum {
    /// #     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    /// #     rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    /// #     pivot: Revolute(ground.origin, rod.a),
    /// # });
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let mut simulation = Simulation::new(Pendulum {})?;
    /// let mut dynamics = simulation.dynamics()?;
    /// let mut greatest = 0.0_f64;
    /// for _ in 0..1000 {
    ///     simulation.step()?;
    ///     simulation.update(&mut dynamics)?;
    ///     greatest = greatest.max(dynamics.reaction("pivot", "fy")?);
    /// }
    /// // A rod that falls from the horizontal pulls with 5/2 of its weight at the lowest point.
    /// assert!((greatest - 2.5 * 9.81).abs() < 1e-3);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Dynamics::evaluate`].
    pub fn update(&self, dynamics: &mut Dynamics<S, Q, N, R>) -> Result<(), SimulationError> {
        if dynamics.revision != self.revision {
            *dynamics = self.dynamics()?;
            return Ok(());
        }
        let state = self.state();
        let (q, v) = (&state.positions, &state.velocities);
        dynamics.follow(self.system().inputs(), state.time, q, v)
    }

    /// Joint reactions at the current instant, from the equations at acceleration level.
    ///
    /// # Errors
    /// A mass matrix that is not positive definite, or rows that admit no finite multiplier.
    pub fn reactions(&self) -> Result<Reactions, SimulationError> {
        crate::reactions::reactions(self.system(), self.state(), self.settings.step)
            .map_err(|fault| self.fault(fault))
    }

    fn fault(&self, fault: Fault) -> SimulationError {
        SimulationError::from_fault(fault, S::MODEL, self.time(), self.settings.step)
    }

    /// The multipliers λ that the method applied in its last step: its constraint force was f_c = Aᵀλ; N or N m for
    /// rows in m or rad, in the order of [`Model::rows`]. Of the two-level method and RATTLE (κ₁ + κ₂)/h and of Algorithm 1
    /// and M-ALF [M̄μ]/h + ½ Σ (c̄μ + k̄λ − f̄), the last term of (21): both the mean over the step. Of generalized α, backward
    /// differentiation, Radau and penalties the λ at its end, and of index-3 projections that of the projected accelerations
    /// there. (After a step of backward differentiation that is much shorter than those before it is λ of the last longer one.) `None`
    /// for methods without such an unknown, before the first step, and after one that has failed.
    ///
    /// Where rows are redundant, or a singular pose lies within the step, they need not be those of
    /// [`Simulation::reactions`].
    pub fn step_multipliers(&self) -> Option<SVector<f64, R>> {
        self.multipliers_before
            .unwrap_or_else(|| self.integrator.multipliers())
    }

    /// One component of a joint's reaction, as [`Model::reactions`](crate::Model::reactions) names them: the force or
    /// torque on the child, in world axes. It solves the equations at acceleration level: without allocation if there are
    /// at most 16 velocities and 16 rows, which are clearly independent, and at most 256 components;
    /// [`Simulation::update`] with [`Dynamics::reaction`] never allocates.
    ///
    /// # Errors
    /// An unknown joint, or one without this component; otherwise as [`Simulation::reactions`].
    pub fn reaction(&self, joint: &str, component: &str) -> Result<f64, SimulationError> {
        let index = S::MODEL.reaction_index(joint, component)?;
        crate::reactions::reaction(self.system(), self.state(), index)
            .map_err(|fault| self.fault(fault))
    }

    /// The current instant as a row of results.
    pub fn sample(&self) -> Sample {
        let trace = self.integrator.trace();
        Sample {
            time: self.time(),
            outputs: self.output_values(),
            energy: self.energy(),
            holonomic_error: largest(trace.phi),
            velocity_error: largest(&trace.rates),
        }
    }

    /// What assembly found, at the start or where parameters changed last.
    pub fn assembly(&self) -> &AssemblyVerdict {
        &self.assembly
    }

    /// The singular poses passed so far, in the order of time, the last 64 of them; [`Report::rank_losses`] counts all. Rows that are
    /// always redundant do not count.
    pub fn rank_losses(&self) -> &[RankLoss] {
        self.singularities.losses()
    }

    /// The work of all integrators so far.
    fn counters(&self) -> Counters {
        self.counted.and(self.integrator.counters())
    }

    /// Work done and errors met so far.
    pub fn report(&self) -> Report {
        let counters = self.counters();
        Report {
            steps: self.books.steps,
            stages: counters.stages,
            iterations: counters.iterations,
            rejected_steps: self.rejected + counters.rejected,
            placed_steps: self.placed,
            regularised_solves: counters.regularised,
            energy_error: self.books.energy_error,
            holonomic_error: self.books.holonomic_error,
            velocity_error: self.books.velocity_error,
            rank: self.assembly.rank,
            rank_losses: self.singularities.count(),
            method_changes: self.method_changes().len(),
        }
    }
}
