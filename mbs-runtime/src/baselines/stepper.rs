//! One interface for all baselines.

use super::Works;
use super::adaptive::Adaptive;
use super::baumgarte::Explicit;
use super::bdf::Bdf;
use super::bench::Bench;
use super::generalized_alpha::GeneralizedAlpha;
use super::index3_projections::Index3;
use super::penalty::Penalty;
use super::rattle::Rattle;
use crate::alf3f::Counters;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::row_scale::RowScale;
use crate::singular::RankMargin;
use crate::yardstick::Yardstick;
use crate::{Method, Settings, SimulationError, State, Structure, System};
use nalgebra::SVector;

/// A baseline by itself: steps of any length, without energy balance or report.
///
/// A step allocates nothing. [`Simulation`](crate::Simulation) wraps it; use it directly to measure.
pub struct BaselineStepper<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) bench: Bench<S, Q, N, R>,
    rule: Rule<S, Q, N, R>,
}

/// The method and its workspace.
enum Rule<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    Explicit(Box<Explicit<Q, N, R>>),
    Adaptive(Box<Adaptive<Q, N, R>>),
    Rattle(Box<Rattle<S, Q, N, R>>),
    Penalty(Box<Penalty<N, R>>),
    Index3(Box<Index3<N, R>>),
    GeneralizedAlpha(Box<GeneralizedAlpha<N, R>>),
    Bdf(Box<Bdf<Q, N, R>>),
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
        settings.check()?;
        if let Some(because) = refusal(&settings.method, &S::STRUCTURE, R) {
            return Err(SimulationError::Method {
                method: settings.method.name(),
                because,
            });
        }
        let time = state.time;
        let fault =
            |fault: Fault| SimulationError::from_fault(fault, S::MODEL, time, settings.step);
        let yardstick = Box::new(Yardstick::new(&system, settings.step));
        let rule = match &settings.method {
            Method::Baumgarte(baumgarte) => match baumgarte.adaptive {
                None => Rule::Explicit(Box::new(Explicit::stabilised(settings.order, baumgarte))),
                Some(tolerance) => {
                    Rule::Adaptive(Box::new(Adaptive::new(baumgarte.gain, tolerance)))
                }
            },
            Method::Projected => Rule::Explicit(Box::new(
                Explicit::projected(&system, &state, &yardstick, settings).map_err(fault)?,
            )),
            Method::Rattle => Rule::Rattle(Box::new(
                Rattle::new(&system, &state.positions, &yardstick, settings).map_err(fault)?,
            )),
            Method::Penalty(penalty) => {
                let scale = RowScale::new(&system, &yardstick, settings).map_err(fault)?;
                Rule::Penalty(Box::new(Penalty::new(*penalty, scale)))
            }
            Method::Index3Projections(projections) => {
                Rule::Index3(Box::new(Index3::new(projections)))
            }
            Method::GeneralizedAlpha(alpha) => {
                Rule::GeneralizedAlpha(Box::new(GeneralizedAlpha::new(alpha)))
            }
            Method::Bdf(bdf) => Rule::Bdf(Box::new(Bdf::new(bdf))),
            Method::TwoLevel | Method::Paper(_) | Method::MAlf(_) => {
                return Err(SimulationError::Setting {
                    name: "method",
                    value: f64::NAN,
                    wanted: "one of the baselines",
                });
            }
        };
        let geometry = ConstraintGeometry::new(&system, &state.positions).map_err(fault)?;
        let mut stepper = BaselineStepper {
            bench: Bench {
                system,
                state,
                geometry,
                phi: SVector::zeros(),
                settled: false,
                counters: Counters::default(),
                works: Works::default(),
                multipliers: None,
                max_iterations: settings.max_iterations,
                yardstick,
            },
            rule,
        };
        stepper.bench.settle().map_err(fault)?;
        Ok(stepper)
    }

    /// Advances by h seconds.
    ///
    /// # Errors
    /// A row that does not converge, by name; a state that is not finite; a mass matrix that is not positive definite.
    /// The state is then still that before the step.
    #[inline]
    pub fn step(&mut self, h: f64) -> Result<(), SimulationError> {
        self.try_step(h)
            .map_err(|fault| SimulationError::from_fault(fault, S::MODEL, self.bench.state.time, h))
    }

    #[inline(always)]
    fn try_step(&mut self, h: f64) -> Result<(), Fault> {
        if !(h.is_finite() && h != 0.0) {
            return Err(Fault::NonFinite("step"));
        }
        self.bench.works = Works::default();
        let outcome = match &mut self.rule {
            Rule::Explicit(rule) => rule.step(&mut self.bench, h),
            Rule::Adaptive(rule) => rule.advance(&mut self.bench, h),
            Rule::Rattle(rule) => rule.step(&mut self.bench, h),
            Rule::Penalty(rule) => rule.step(&mut self.bench, h),
            Rule::Index3(rule) => rule.step(&mut self.bench, h),
            Rule::GeneralizedAlpha(rule) => rule.step(&mut self.bench, h),
            Rule::Bdf(rule) => rule.advance(&mut self.bench, h),
        };
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

    /// λ at the end of the last step; `None` for methods that have no such unknown.
    pub(crate) fn multipliers(&self) -> Option<SVector<f64, R>> {
        self.bench.multipliers
    }

    pub(crate) fn counters(&self) -> Counters {
        self.bench.counters
    }

    /// The rank margin of the rows at the current state; `None` if there are no rows, or if the method does not compute
    /// it.
    pub(crate) fn rank_margin(&mut self) -> Option<RankMargin> {
        match &mut self.rule {
            Rule::Explicit(rule) => rule.rank_margin(&mut self.bench),
            _ => None,
        }
    }

    /// The weight of each row in the combination that is nearest to dependence.
    pub(crate) fn weakest_rows(&self) -> SVector<f64, R> {
        match &self.rule {
            Rule::Explicit(rule) => rule.weakest_rows(&self.bench),
            _ => SVector::zeros(),
        }
    }

    /// How far the evaluations of the last step stayed from singular poses, as a fraction of the way.
    pub(crate) fn clearance(&self) -> f64 {
        match &self.rule {
            Rule::Explicit(rule) => rule.clearance(),
            _ => f64::INFINITY,
        }
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
        match &mut self.rule {
            Rule::Rattle(rule) => rule.refresh(),
            Rule::Index3(rule) => rule.refresh(),
            Rule::GeneralizedAlpha(rule) => rule.refresh(),
            Rule::Bdf(rule) => rule.refresh(),
            Rule::Explicit(rule) => rule.refresh(),
            // The springs of penalties are those of the start.
            Rule::Adaptive(_) | Rule::Penalty(_) => {}
        }
        self.bench.settled = false;
        self.bench.settle()
    }
}

/// Why a method cannot integrate such a mechanism; `None` if it can.
fn refusal(method: &Method, structure: &Structure, rows: usize) -> Option<&'static str> {
    let nonholonomic = rows > structure.holonomic_rows;
    match method {
        Method::Rattle if structure.velocity_forces => {
            Some("forces depend on velocities, and its kicks know forces of position alone")
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
