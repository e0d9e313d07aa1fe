//! How a simulation begins: from the declared guess, or from a state.

use super::Simulation;
use super::books::Books;
use super::energy_guard::EnergyGuard;
use super::other_methods::OtherMethods;
use super::singularity_detector::SingularityDetector;
use crate::alf3f::Counters;
use crate::assembly::{Wanted, assemble, check_rates};
use crate::integrator::Integrator;
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{
    AssemblyVerdict, Energy, Mechanism, PosesAhead, Settings, SimulationError, State, System,
};

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// With `other` for the methods other than the two-level one, from the declared guess; `ASKED` if values may be wanted.
    pub(super) fn assembled<M: Mechanism<System = S>, const ASKED: bool>(
        mechanism: M,
        settings: Settings,
        wanted: &[Wanted],
        other: Option<&'static OtherMethods<Self, S, Q, N, R>>,
    ) -> Result<Self, SimulationError> {
        settings.check()?;
        let system = mechanism.prepare()?;
        let (state, assembly) = assemble::<S, Q, N, R, ASKED>(&system, &settings, wanted)?;
        Self::begin(system, settings, state, assembly, other)
    }

    /// The same from a state.
    pub(super) fn resumed<M: Mechanism<System = S>>(
        mechanism: M,
        settings: Settings,
        state: State<Q, N, R>,
        other: Option<&'static OtherMethods<Self, S, Q, N, R>>,
    ) -> Result<Self, SimulationError> {
        settings.check()?;
        let mut system = mechanism.prepare()?;
        state.give_inputs(&mut system)?;
        let verdict = crate::assembly::inspect(&system, &settings, &state)?;
        let simulation = Self::begin(system, settings, state, verdict, other)?;
        let rates = simulation.integrator.trace().rates;
        let yardstick = &simulation.yardstick;
        let scale = RowScale::new(simulation.system(), yardstick, &settings)
            .map_err(|fault| simulation.fault(fault))?;
        let speed = yardstick.measure(simulation.velocities());
        check_rates(S::MODEL, &rates, &scale, (&settings, speed))?;
        Ok(simulation)
    }

    /// From a state that satisfies the rows, with the method of the settings.
    pub(super) fn from_state(
        system: S,
        settings: Settings,
        state: State<Q, N, R>,
        assembly: AssemblyVerdict,
        other: Option<&'static OtherMethods<Self, S, Q, N, R>>,
    ) -> Result<Self, SimulationError> {
        // In parts, whose frames are not on the stack together: without optimisation each move of a large state is a copy.
        let make = other.map(|other| other.make);
        match Integrator::new(system, state, &settings, make) {
            Ok(integrator) => Ok(Self::with_integrator(integrator, settings, assembly, other)),
            Err(error) => Err(error),
        }
    }

    #[inline(never)]
    fn with_integrator(
        mut integrator: Integrator<S, Q, N, R>,
        settings: Settings,
        assembly: AssemblyVerdict,
        other: Option<&'static OtherMethods<Self, S, Q, N, R>>,
    ) -> Self {
        integrator.note_inputs();
        let yardstick = Box::new(Yardstick::new(integrator.system(), settings.step));
        let by_position = S::STRUCTURE.holonomic_rows == R && !S::STRUCTURE.rheonomic;
        let is_estimated = S::STATES.is_empty() && integrator.estimate().is_some();
        let form_a_curve = by_position && assembly.rank + 1 + S::STATES.len() == N;
        integrator.state_mut().known_poses.make_room(form_a_curve);
        let (system, state) = (integrator.system(), integrator.state());
        let (energy_guard, range) = EnergyGuard::new(system, state, &yardstick, &settings);
        integrator.state_mut().ledger.range = Some(range);
        let State {
            time,
            positions,
            velocities,
            ..
        } = integrator.state();
        let imperceptible = yardstick.imperceptible(positions, settings.step);
        let is_at_rest = yardstick.measure(velocities) <= imperceptible;
        let rest = is_at_rest.then_some(*time);
        let [step_start, pair_start, pair_end, mut last_step_start] =
            [(); 4].map(|()| integrator.state().boxed_copy());
        last_step_start.time = f64::INFINITY;
        let mut simulation = Simulation {
            step_start,
            pair_start,
            pair_end,
            last_step_start,
            balance: Energy::default(),
            energy_guard,
            yardstick,
            integrator,
            settings,
            other,
            choice: None,
            assembly,
            books: Books::EMPTY,
            counted: Counters::default(),
            rejected: 0,
            placed: 0,
            rank_margin: None,
            multipliers_before: None,
            books_at_step_start: Books::EMPTY,
            poses_at_step_start: PosesAhead::default(),
            is_estimated,
            singularities: SingularityDetector::new(rest),
            revision: 0,
            refused: None,
            events: vec![0.0; S::MODEL.events.len()],
        };
        simulation.take_stock();
        if simulation.state().ledger.initial.is_none() {
            let total = crate::energy::total(simulation.system(), simulation.state());
            simulation.integrator.state_mut().ledger.initial = Some(total);
        }
        simulation.balance = simulation.energy();
        let balance = simulation.balance;
        if let Some(range) = &mut simulation.integrator.state_mut().ledger.range {
            range.note(&balance);
        }
        simulation.rank_margin = simulation.integrator.rank_margin();
        simulation.watch();
        simulation
    }
}
