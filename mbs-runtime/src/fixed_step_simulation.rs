//! A mechanism in motion by steps of one length, for control loops and for targets without an operating system.

use crate::acceleration_level::outputs;
use crate::alf3f::StepMonitor;
use crate::assembly::{check, closed};
use crate::fault::Fault;
use crate::{
    Energy, Mechanism, Method, NamedValues, Settings, SimulationError, State, System,
    TwoLevelStepper,
};
use nalgebra::SVector;

/// A mechanism with Q coordinates, N velocities and R constraint rows, and the two-level integrator: every step has the
/// length [`Settings::step`].
///
/// It is what [`Simulation`](crate::Simulation) is with [`Settings::placement`] off and without what lists need: events,
/// samples, reports, values that the declaration holds. No step is tried again in parts: one that does not converge is
/// an error. Nothing is allocated if the crate is built without the feature `std`, not even at the start.
///
/// ```
/// use mbs_runtime::{FixedStepSimulation, Settings, mechanism};
///
/// mechanism!(Pendulum {
///     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
///     motor_torque: Input(unit = Nm),
///     rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = -90.0_deg),
///     pivot: Revolute(ground.origin, rod.a),
///     motor: Torque(on = rod, value = motor_torque),
///     angle: Output(rod.angle),
/// });
///
/// # fn main() -> Result<(), mbs_runtime::SimulationError> {
/// let settings = Settings { step: 1e-3, ..Settings::default() };
/// let mut plant: PendulumFixedStepSimulation = FixedStepSimulation::new(Pendulum {}, settings)?;
/// for _ in 0..100 {
///     let torque = -2.0 * plant.outputs().angle;
///     plant.set_inputs(PendulumInputs { motor_torque: torque })?;
///     plant.step()?;
/// }
/// assert!(plant.energy().error.abs() < 1e-3);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct FixedStepSimulation<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    stepper: TwoLevelStepper<S, Q, N, R>,
    /// The length of a step, s.
    step: f64,
    /// Power of the forces without potential at the current instant, W.
    power: f64,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    FixedStepSimulation<S, Q, N, R>
{
    /// A simulation that starts from the declared guess, with its rows closed.
    ///
    /// # Errors
    /// Parameters that do not make a mechanism; a guess that cannot be assembled, or of which the declaration holds
    /// values; settings with another method than the two-level one, with a tolerance or with an accuracy.
    pub fn new<M: Mechanism<System = S>>(
        mechanism: M,
        settings: Settings,
    ) -> Result<Self, SimulationError> {
        check_settings(&settings)?;
        let system = mechanism.prepare()?;
        let state = closed(&system, &settings)?;
        Self::begin(system, state, &settings)
    }

    /// A simulation that continues from a state, for example of a [`Simulation`](crate::Simulation), with its inputs. (Without the
    /// feature `std` a state has none: they are those that are declared.)
    ///
    /// # Errors
    /// As [`FixedStepSimulation::new`], and a state that is not finite or violates the constraints.
    pub fn resume<M: Mechanism<System = S>>(
        mechanism: M,
        settings: Settings,
        state: State<Q, N, R>,
    ) -> Result<Self, SimulationError> {
        check_settings(&settings)?;
        #[cfg_attr(not(feature = "std"), allow(unused_mut))]
        let mut system = mechanism.prepare()?;
        #[cfg(feature = "std")]
        state.give_inputs(&mut system)?;
        check(&system, &settings, &state)?;
        Self::begin(system, state, &settings)
    }

    #[inline(never)]
    fn begin(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<Self, SimulationError> {
        let mut simulation = FixedStepSimulation {
            stepper: TwoLevelStepper::new(system, state, settings)?,
            step: settings.step,
            power: 0.0,
        };
        simulation.note_inputs();
        simulation.take_stock();
        let energy = simulation.energy();
        let ledger = &mut simulation.stepper.context.state.ledger;
        // Its steps are not judged, and do not keep this up.
        ledger.range = None;
        ledger
            .initial
            .get_or_insert(energy.kinetic + energy.potential);
        Ok(simulation)
    }

    /// One step of [`Settings::step`].
    ///
    /// # Errors
    /// A row that does not converge, by name, or a state that is not finite. The state is then that before the step.
    pub fn step(&mut self) -> Result<(), SimulationError> {
        let state = self.state();
        let start = (state.time, state.clock);
        let mut monitor = StepMonitor::new(self.power, None);
        self.stepper.pass(self.step, &mut monitor)?;
        self.power = monitor.power;
        let state = &mut self.stepper.context.state;
        state.count(start, self.step);
        state.ledger.nonconservative_work += monitor.nonconservative_work;
        state.ledger.drive_work += monitor.drive_work;
        Ok(())
    }

    /// The current state; [`FixedStepSimulation::resume`] continues from it.
    pub fn state(&self) -> &State<Q, N, R> {
        self.stepper.state()
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        self.state().time
    }

    /// q, in the order and units of [`Model::coordinates`](crate::Model::coordinates).
    pub fn positions(&self) -> &SVector<f64, Q> {
        &self.state().positions
    }

    /// v, in the order and units of [`Model::velocities`](crate::Model::velocities).
    pub fn velocities(&self) -> &SVector<f64, N> {
        &self.state().velocities
    }

    /// The `Output`s at the current instant as fields, each with its unit in its documentation.
    pub fn outputs(&self) -> S::Outputs {
        S::Outputs::from_values(|values| outputs(self.system(), self.state(), values))
    }

    /// The current values of the `Input`s as fields.
    pub fn inputs(&self) -> S::Inputs {
        let current = self.system().inputs().iter();
        S::Inputs::from_values(|inputs| {
            for (input, &value) in inputs.iter_mut().zip(current) {
                *input = value;
            }
        })
    }

    /// Sets the `Input`s from now on, or none if one of them is NaN or infinite. Where a `Drive` follows an input, the mechanism gets
    /// to its new place in the next step, and is as fast as this takes: change such an input in small parts. The work of this is not in
    /// the energy balance. A [`Simulation`](crate::Simulation) moves it at once.
    ///
    /// # Errors
    /// A value that is NaN or infinite, with the name of its input.
    pub fn set_inputs(&mut self, inputs: S::Inputs) -> Result<(), SimulationError> {
        let changes = inputs.with_values(|values| {
            let mut named = values.iter().zip(S::MODEL.inputs);
            if let Some((&value, input)) = named.find(|(value, _)| !value.is_finite()) {
                let name = input.name;
                return Err(SimulationError::Input { name, value });
            }
            let current = self.stepper.context.system.inputs_mut();
            let changes = *current != *values;
            current.copy_from_slice(values);
            Ok(changes)
        })?;
        if !changes {
            return Ok(());
        }
        self.note_inputs();
        self.stepper.context.state.forget_factors();
        let refreshed = self.stepper.refresh();
        refreshed.map_err(|fault| self.error(fault))?;
        self.take_stock();
        Ok(())
    }

    /// The energy balance.
    pub fn energy(&self) -> Energy {
        crate::energy::balance(self.system(), self.state())
    }

    /// The equations.
    pub fn system(&self) -> &S {
        &self.stepper.context.system
    }

    /// The state has the inputs, too, where it has any.
    fn note_inputs(&mut self) {
        #[cfg(feature = "std")]
        {
            let context = &mut self.stepper.context;
            context.state.inputs.clear();
            context
                .state
                .inputs
                .extend_from_slice(context.system.inputs());
        }
    }

    /// Power at the current instant, for the energy balance of the next step.
    fn take_stock(&mut self) {
        let state = self.state();
        let (q, v) = (&state.positions, &state.velocities);
        self.power = self.system().nonconservative_power(state.time, q, v);
    }

    fn error(&self, fault: Fault) -> SimulationError {
        SimulationError::from_fault(fault, S::MODEL, self.time(), self.step)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> core::fmt::Debug
    for FixedStepSimulation<S, Q, N, R>
{
    fn fmt(&self, out: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        out.debug_struct("FixedStepSimulation")
            .field("mechanism", &S::MODEL.name)
            .field("state", self.state())
            .finish_non_exhaustive()
    }
}

/// Refuses settings that choose the lengths of steps, or another method.
fn check_settings(settings: &Settings) -> Result<(), SimulationError> {
    settings.check()?;
    if settings.method != Method::TwoLevel {
        let method = settings.method.name();
        return Err(SimulationError::NotCompiled { method });
    }
    let chosen = [
        ("tolerance", settings.tolerance),
        ("accuracy", settings.accuracy),
    ];
    match chosen
        .into_iter()
        .find_map(|(name, value)| Some((name, value?)))
    {
        Some((name, value)) => Err(SimulationError::Setting {
            name,
            value,
            wanted: "`None`: all steps have one length here",
        }),
        None => Ok(()),
    }
}
