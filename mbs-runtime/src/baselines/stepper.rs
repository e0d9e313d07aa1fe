//! One interface for all baselines.

use super::Works;
use super::bench::Bench;
use super::registry;
use super::rule::{AnyRule, MakeRule};
use crate::alf3f::Counters;
use crate::constraint_geometry::ConstraintGeometry;
use crate::estimate::Estimate;
use crate::fault::Fault;
use crate::singular::RankMargin;
use crate::yardstick::Yardstick;
use crate::{Method, Settings, SimulationError, State, Structure, System};
use nalgebra::SVector;
use std::fmt;

/// A baseline by itself: steps of any length, without energy balance or report.
///
/// A step allocates nothing. [`Simulation`](crate::Simulation) wraps it; use it directly to measure.
#[derive(Clone)]
pub struct BaselineStepper<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) bench: Bench<S, Q, N, R>,
    rule: AnyRule<S, Q, N, R>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    BaselineStepper<S, Q, N, R>
{
    /// An integrator that starts from `state`, which has to satisfy the constraints.
    ///
    /// # Errors
    /// Settings that cannot be used, a method that is none of the baselines or cannot integrate this mechanism, or a mass
    /// matrix that is not positive definite at the state.
    pub fn new(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<Self, SimulationError> {
        let is_other = matches!(
            settings.method,
            Method::TwoLevel | Method::Paper(_) | Method::MAlf(_)
        );
        settings.require_method(!is_other, "one of the baselines")?;
        Self::with(registry::any, system, state, settings)
    }

    /// The same with the rule of one baseline, so that the others are not compiled.
    pub(crate) fn with(
        make: MakeRule<S, Q, N, R>,
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<Self, SimulationError> {
        settings.check()?;
        let method = settings.method.name();
        if let Some(because) = refusal(&settings.method, &S::STRUCTURE, R, !S::STATES.is_empty()) {
            return Err(SimulationError::Method { method, because });
        }
        let time = state.time;
        let fault =
            |fault: Fault| SimulationError::from_fault(fault, S::MODEL, time, settings.step);
        let mut bench = Bench {
            yardstick: Box::new(Yardstick::new(&system, settings.step)),
            geometry: ConstraintGeometry::new(&system, &state.positions).map_err(fault)?,
            system,
            state,
            phi: SVector::zeros(),
            settled: false,
            rows_alone: false,
            counters: Counters::default(),
            works: Works::default(),
            multipliers: None,
            max_iterations: settings.max_iterations,
        };
        let rule = make(&bench, settings)
            .ok_or(SimulationError::NotCompiled { method })?
            .map_err(fault)?;
        bench.rows_alone = rule.is_sparse();
        bench.settle().map_err(fault)?;
        Ok(BaselineStepper { bench, rule })
    }

    /// Advances by h seconds.
    ///
    /// # Errors
    /// A length of zero, or one that is not finite or back in time for a method that has no such steps; a row that does not converge,
    /// by name; a state that is not finite; a mass matrix that is not positive definite. The state is then that before the step, or,
    /// of a method that divides it into steps of its own, where it could not go on.
    #[inline]
    pub fn step(&mut self, h: f64) -> Result<(), SimulationError> {
        self.try_step(h)
            .map_err(|fault| SimulationError::from_fault(fault, S::MODEL, self.bench.state.time, h))
    }

    #[inline(always)]
    fn try_step(&mut self, h: f64) -> Result<(), Fault> {
        Fault::check_length(h, true)?;
        self.bench.works = Works::default();
        let outcome = self.rule.advance(&mut self.bench, h);
        // A step that failed leaves the geometry of its last trial.
        self.bench.settled &= outcome.is_ok();
        outcome
    }

    /// The equations.
    pub fn system(&self) -> &S {
        &self.bench.system
    }

    /// The current state.
    pub fn state(&self) -> &State<Q, N, R> {
        &self.bench.state
    }

    /// λ of the last step; `None` for methods that have no such unknown.
    pub(crate) fn multipliers(&self) -> Option<SVector<f64, R>> {
        self.bench.multipliers
    }

    pub(crate) fn counters(&self) -> Counters {
        self.bench.counters
    }

    /// The rank margin of the rows at the current state; `None` if there are no rows, or if the method does not compute
    /// it.
    pub(crate) fn rank_margin(&mut self) -> Option<RankMargin> {
        self.rule.rank_margin(&mut self.bench)
    }

    /// The weight of each row in the combination that is nearest to dependence.
    pub(crate) fn weakest_rows(&mut self) -> SVector<f64, R> {
        self.rule.weakest_rows(&self.bench)
    }

    /// See [`Rule::estimate`](super::rule::Rule::estimate).
    pub(crate) fn estimate(&self) -> Option<Estimate> {
        self.rule.estimate(&self.bench)
    }

    /// Whether its elimination is planned.
    pub(crate) fn is_sparse(&self) -> bool {
        self.rule.is_sparse()
    }

    /// How far the evaluations of the last step stayed from singular poses, as a fraction of the way.
    pub(crate) fn clearance(&self) -> f64 {
        self.rule.clearance()
    }

    /// See [`Rule::expected_clearance`](super::rule::Rule::expected_clearance).
    pub(crate) fn expected_clearance(&self, length: f64) -> f64 {
        self.rule.expected_clearance(length)
    }

    /// See [`Rule::pose_within`](super::rule::Rule::pose_within).
    pub(crate) fn pose_within(&self) -> Option<f64> {
        self.rule.pose_within()
    }

    /// Results of the last step: its works, and the rows at its end.
    pub(crate) fn take_stock(&mut self) -> Result<Works, SimulationError> {
        let time = self.bench.state.time;
        let works = self.bench.works;
        let fault = |fault| SimulationError::from_fault(fault, S::MODEL, time, 0.0);
        self.bench.settle().map(|()| works).map_err(fault)
    }

    /// Forgets what was known of the current instant, after the state or an input was changed.
    pub(crate) fn refresh(&mut self) -> Result<(), Fault> {
        self.rule.refresh();
        self.bench.settled = false;
        self.bench.settle()
    }
}

/// Why a method cannot integrate such a mechanism; `None` if it can.
fn refusal(
    method: &Method,
    structure: &Structure,
    rows: usize,
    states: bool,
) -> Option<&'static str> {
    let nonholonomic = rows > structure.holonomic_rows;
    match method {
        Method::Rattle if structure.velocity_forces => {
            Some("forces depend on velocities, and its kicks know forces of position alone")
        }
        Method::Bdf(_) if states => {
            Some("it has states, and BDF chooses its steps by the errors of positions alone")
        }
        Method::Rattle if nonholonomic => {
            Some("it has nonholonomic rows, and RATTLE satisfies positions")
        }
        Method::Index3Projections(_) if nonholonomic => {
            Some("it has nonholonomic rows, which the augmented Lagrangian of index 3 cannot see")
        }
        _ => None,
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> fmt::Debug
    for BaselineStepper<S, Q, N, R>
{
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("BaselineStepper")
            .field("mechanism", &S::MODEL.name)
            .field("state", &self.bench.state)
            .finish_non_exhaustive()
    }
}
