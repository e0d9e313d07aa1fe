//! The two-level ALF-3F integrator: the default.

use super::embedded::Embedded;
use super::extrapolation::Extrapolation;
use super::implicit_step::Outcome;
use super::kick_flow_kick::kick_flow_kick;
use super::large::SparseStep;
use super::sparse_kicks::SparseKicks;
use super::step_context::{Counters, Dense, StepContext};
use super::stepping::Stepping;
use super::{CLEAR, StagePlacement, StepMonitor, composition};
use crate::fault::Fault;
use crate::large::{check_dense, is_large, may_be_sparse};
use crate::linear::{add, added, vector};
use crate::memory::{Box, MOST_STAGES};
use crate::singular::RankMargin;
use crate::{Flow, Method, Settings, SimulationError, State, System};
use core::fmt;
use nalgebra::SVector;

/// With a smaller σ another branch of the motion is within reach of a step.
const NEAR: f64 = 0.3;
/// The distance of a singular pose from the ends of the parts of an extrapolated step, as a part of the step, above which it
/// is accepted. All columns have an end in the middle of the step, and others in common; of order 8 they are 1/24 apart.
const GAP: f64 = 0.005;

/// The integrator by itself: steps of any length, without energy balance or report.
///
/// A step allocates nothing and has the given length, near singular poses too. [`Simulation`](crate::Simulation) wraps
/// it; use it directly to measure, or to compose steps.
#[derive(Clone)]
pub struct TwoLevelStepper<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) context: StepContext<S, Q, N, R>,
    flow: Stepping<Q, N, R>,
    /// Fractions of a step.
    stages: &'static [f64],
    /// Instead of a composition, where forces depend on velocities.
    extrapolation: Option<Extrapolation>,
    /// With a tolerance, for a composition.
    embedded: Option<Box<Embedded<N>>>,
    /// The distance of the means of two orders of the last extrapolated step.
    apart: f64,
    /// The state before a step of several stages.
    before: Box<State<Q, N, R>>,
    placement: StagePlacement,
    /// κ₁ + κ₂ over the stages of the last composed step, N s …
    impulse: SVector<f64, R>,
    /// The length of the last step, s.
    length: f64,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    TwoLevelStepper<S, Q, N, R>
{
    /// An integrator that starts from `state`, which has to satisfy the constraints.
    ///
    /// # Errors
    /// Settings that cannot be used or with another method, or a mass matrix that is not positive definite at the state.
    pub fn new(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<Self, SimulationError> {
        settings.require_method(settings.method == Method::TwoLevel, "`Method::TwoLevel`")?;
        Self::for_steps(system, state, settings, false)
    }

    /// The same; `placed` if the lengths of its steps are chosen beside singular poses.
    pub(crate) fn for_steps(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
        placed: bool,
    ) -> Result<Self, SimulationError> {
        settings.check()?;
        let flow = crate::flow::choose(&system, &state, settings)?;
        let time = state.time;
        let is_high = settings.order > 2;
        let implicit = is_high && flow == Flow::Implicit;
        if implicit && !S::STRUCTURE.velocity_forces {
            return Err(SimulationError::Order {
                order: settings.order,
                because: "the implicit flow was asked for, which is not symmetric; leave `flow` out",
            });
        }
        let explicit = flow == Flow::Leapfrog && S::STRUCTURE.holonomic_rows == R;
        if let (Some(count), false) = (settings.fixed_iterations, explicit) {
            return Err(SimulationError::Setting {
                name: "fixed_iterations",
                value: count as f64,
                wanted: "`None` here: only kicks with the leapfrog flow and without nonholonomic rows have a known cost",
            });
        }
        let extrapolation = implicit.then(|| Extrapolation::new(settings.order));
        let (stages, count) = match &extrapolation {
            Some(extrapolation) => (composition::stages(2), extrapolation.parts()),
            None => {
                let stages = composition::stages(settings.order);
                (stages, stages.len())
            }
        };
        if count > MOST_STAGES {
            return Err(SimulationError::Order {
                order: settings.order,
                because: "`mbs-runtime` was built without its feature `std`, and has room for one stage",
            });
        }
        let embedded = match (settings.tolerance, &extrapolation) {
            (Some(_), None) => Embedded::new(settings.order).map(Box::new),
            _ => None,
        };
        let mut state = state;
        state.make_room(count);
        let large = match flow == Flow::Implicit && may_be_sparse::<N, R>(settings) {
            true => SparseStep::new(&system, &state),
            false => None,
        };
        #[cfg(feature = "sparse")]
        state.keep_factors(large.is_some());
        let before = state.boxed_copy();
        if large.is_none() {
            check_dense(N, flow)?;
        }
        let kicks = flow == Flow::Leapfrog && settings.fixed_iterations.is_none();
        let dense = match kicks.then(|| SparseKicks::<N, R>::usual_pivot(&system)) {
            _ if large.is_some() => Dense::Never,
            Some(Some(usual)) => Dense::WhenNeeded(usual),
            _ => Dense::AtOnce,
        };
        let mut context = match StepContext::new(system, state, settings, placed, dense) {
            Ok(context) => context,
            Err(fault) => {
                let error = SimulationError::from_fault(fault, S::MODEL, time, settings.step);
                return Err(error);
            }
        };
        let flow = Stepping::new(flow, &mut context, settings, large);
        Ok(TwoLevelStepper {
            context,
            flow,
            placement: StagePlacement::new(stages),
            stages,
            extrapolation,
            embedded,
            apart: 0.0,
            before,
            impulse: SVector::zeros(),
            length: 0.0,
        })
    }

    /// One step of h seconds (negative: back in time).
    ///
    /// # Errors
    /// A row that does not converge, by name; a state that is not finite; a mass matrix that is not positive definite.
    /// The state is then still that before the step.
    #[inline]
    pub fn step(&mut self, h: f64) -> Result<(), SimulationError> {
        if self.stages.len() > 1 || self.extrapolation.is_some() {
            return self.composed(h);
        }
        self.length = h;
        let state = &self.context.state;
        let start = (state.time, state.clock);
        let stepped = self.try_step(h, state.end_of(h));
        self.settle_unwatched();
        self.counted(stepped, start, h)
    }

    #[cold]
    #[inline(never)]
    fn composed(&mut self, h: f64) -> Result<(), SimulationError> {
        let start = (self.context.state.time, self.context.state.clock);
        let composed = self.compose(h, None);
        self.settle_unwatched();
        self.counted(composed, start, h)
    }

    /// The same, and records works and clearances.
    pub(crate) fn pass(
        &mut self,
        h: f64,
        monitor: &mut StepMonitor,
    ) -> Result<(), SimulationError> {
        let is_watched = monitor.rank_margin.is_some();
        let composed = self.compose(h, Some(monitor));
        if !is_watched {
            self.settle_unwatched();
        }
        self.named(composed, h)
    }

    /// The same of a step from `start`, whose length counts exactly.
    #[inline(always)]
    fn counted(
        &mut self,
        outcome: Result<(), Fault>,
        start: (f64, f64),
        h: f64,
    ) -> Result<(), SimulationError> {
        if outcome.is_ok() {
            self.context.state.count(start, h);
        }
        self.named(outcome, h)
    }

    /// What a step of h has come to, a fault with names and time.
    #[inline(always)]
    fn named(&self, outcome: Result<(), Fault>, h: f64) -> Result<(), SimulationError> {
        let time = self.context.state.time;
        outcome.map_err(|fault| SimulationError::from_fault(fault, S::MODEL, time, h))
    }

    /// After a step without rank margins, which do this.
    #[inline(always)]
    fn settle_unwatched(&mut self) {
        let is_dense = !matches!(self.flow, Stepping::Sparse(..) | Stepping::Large(_));
        if is_dense && self.context.scale.is_waiting() {
            self.context.settle_short_rows();
        }
    }

    /// The rank margin of the holonomic rows at the current state; `None` without such rows.
    pub(crate) fn rank_margin(&mut self) -> Option<RankMargin> {
        let rows = S::STRUCTURE.holonomic_rows;
        match &self.flow {
            Stepping::Sparse(kicks, _) => return Some(kicks.rank_margin()),
            Stepping::Large(_) => return None,
            _ => {}
        }
        (rows > 0).then(|| self.context.rank_margin())
    }

    /// The length of a composed step, as a fraction of the last one and between these bounds, with the largest
    /// clearance from the singular pose found in it, and this clearance; `None` if there was none.
    pub(crate) fn aim(&self, bounds: [f64; 2]) -> Option<(f64, f64)> {
        self.placement.aim(bounds)
    }

    /// A measure of the error of the last step, in sizes of the mechanism and radians; `None` without a tolerance or stages.
    pub(crate) fn estimate(&self) -> Option<f64> {
        match &self.embedded {
            Some(embedded) => Some(embedded.measure(self.length, &self.context.yardstick)),
            None => self.extrapolation.as_ref().map(|_| self.apart),
        }
    }

    /// How much each row takes part in what is nearest to a loss of independence; after [`Self::rank_margin`].
    pub(crate) fn weakest_rows(&mut self) -> SVector<f64, R> {
        let rows = S::STRUCTURE.holonomic_rows;
        if let Stepping::Sparse(kicks, _) = &mut self.flow {
            return kicks.weakest_rows();
        }
        let StepContext { start, work, .. } = &self.context;
        work.delassus.combination(&start.delassus, rows)
    }

    /// Whether its elimination is planned.
    pub(crate) fn is_sparse(&self) -> bool {
        matches!(self.flow, Stepping::Sparse(..))
    }

    /// Recomputes what is known of the current instant, after the state or an input was changed from outside.
    pub(crate) fn refresh(&mut self) -> Result<(), Fault> {
        match &mut self.flow {
            Stepping::Sparse(kicks, _) => {
                kicks.refresh(&mut self.context);
                Ok(())
            }
            Stepping::Large(step) => {
                step.refresh(&mut self.context);
                Ok(())
            }
            _ => self.context.refresh(),
        }
    }

    /// A v + b at the current instant.
    pub(crate) fn rates(&self) -> SVector<f64, R> {
        let context = &self.context;
        match &self.flow {
            Stepping::Sparse(kicks, _) => kicks.rates(context),
            Stepping::Large(step) => step.rates(context),
            _ => context
                .start
                .velocity_rows(&context.system, &context.state.velocities),
        }
    }

    /// A step in its stages. Each begins with its own multipliers of the last step: as forces they change smoothly from
    /// step to step, while from stage to stage time jumps back and forth.
    #[inline(never)]
    fn compose(&mut self, h: f64, mut monitor: Option<&mut StepMonitor>) -> Result<(), Fault> {
        let several = self.stages.len() > 1;
        self.length = h;
        if const { S::STRUCTURE.velocity_forces } && self.extrapolation.is_some() {
            return self.extrapolate(h, monitor);
        }
        if several {
            if let Stepping::Midpoint(flow) = &mut self.flow {
                flow.forget();
            }
            self.impulse = SVector::zeros();
            self.before.copy_from(&self.context.state);
            if let Some(embedded) = &mut self.embedded {
                embedded.begin(&self.context.state.velocities);
            }
            if let Some(start) = monitor.as_ref().and_then(|monitor| monitor.rank_margin) {
                self.placement.begin(start);
            }
        }
        let end = self.context.state.end_of(h);
        for (index, fraction) in self.stages.iter().enumerate() {
            if several {
                self.context.state.recall_stage(index);
            }
            let end = match index + 1 < self.stages.len() {
                true => self.context.state.time + fraction * h,
                false => end,
            };
            if let Err(fault) = self.try_step(fraction * h, end) {
                if several {
                    self.context.state.copy_from(&self.before);
                    self.refresh()?;
                }
                return Err(fault);
            }
            if several {
                self.context.state.keep_stage(index);
                let [first, second] = &self.context.work.impulse;
                add(&mut self.impulse, &added(first, 1.0, second));
                if let Some(embedded) = &mut self.embedded {
                    embedded.add(index + 1, &self.context.state.velocities);
                }
            }
            if let Some(monitor) = monitor.as_deref_mut() {
                monitor.add(&self.context, fraction * h);
                if monitor.rank_margin.is_some() {
                    if let Stepping::Implicit(..) = self.flow {
                        self.context
                            .work
                            .delassus
                            .factor(&self.context.start.delassus);
                    }
                    if let Some(now) = self.rank_margin() {
                        if several {
                            self.placement.add(now);
                            monitor.rank_margin = Some(now);
                        } else {
                            monitor.land(now);
                        }
                    }
                }
            }
        }
        if let Some(monitor) = monitor
            && several
            && monitor.rank_margin.is_some()
        {
            monitor.clearance = self.placement.settle();
        }
        Ok(())
    }

    /// A step of high order for forces that depend on velocities.
    #[inline(never)]
    fn extrapolate(&mut self, h: f64, monitor: Option<&mut StepMonitor>) -> Result<(), Fault> {
        let (Some(extrapolation), Stepping::Implicit(_, flow)) =
            (&self.extrapolation, &mut self.flow)
        else {
            unreachable!("only the implicit flow extrapolates")
        };
        let (context, before) = (&mut self.context, &mut self.before);
        before.copy_from(&context.state);
        let mut unwatched = StepMonitor::new(0.0, None);
        let monitor = monitor.unwrap_or(&mut unwatched);
        let near = (monitor.rank_margin).is_some_and(|margin| margin.least < NEAR);
        let mut taken = extrapolation.step(context, flow, before, h, monitor);
        if near && matches!(&taken, Ok(taken) if !taken.alike) {
            // Beside a singular pose a part may turn into another branch, where its rows hold as well.
            taken = Err(Fault::Astray(
                h * context.yardstick.measure(&before.velocities),
            ));
        }
        let nearest = match taken {
            Ok(taken) => {
                (self.impulse, self.apart) = (taken.impulse, taken.apart);
                taken.nearest
            }
            Err(fault) => {
                context.state.copy_from(before);
                context.refresh()?;
                return Err(fault);
            }
        };
        if let Some(start) = monitor.rank_margin
            && let Some(now) = self.rank_margin()
        {
            monitor.land(now);
            let gap = nearest / (start.sigma + now.sigma);
            monitor.clearance = monitor.clearance.min(gap * (CLEAR / GAP));
        }
        Ok(())
    }

    #[inline(always)]
    fn try_step(&mut self, h: f64, end: f64) -> Result<(), Fault> {
        Fault::check_length(h, true)?;
        let context = &mut self.context;
        context.end_time = end;
        match &mut self.flow {
            Stepping::Leapfrog(flow) if const { S::STRUCTURE.allows(Flow::Leapfrog) } => {
                kick_flow_kick(context, flow, h)
            }
            Stepping::Sparse(kicks, flow) if const { S::STRUCTURE.allows(Flow::Leapfrog) } => {
                kicks.step(context, flow, h)
            }
            Stepping::Midpoint(flow) if const { S::STRUCTURE.allows(Flow::Midpoint) } => {
                kick_flow_kick(context, &mut **flow, h)
            }
            Stepping::Trapezoid(flow) => kick_flow_kick(context, &mut **flow, h),
            Stepping::Implicit(step, kicks) => match step.step(context, h)? {
                Outcome::Done => Ok(()),
                Outcome::Lost => kick_flow_kick(context, &mut **kicks, h),
            },
            Stepping::Large(step) if const { is_large::<N, R>() } => step.step(context, h),
            Stepping::Leapfrog(_)
            | Stepping::Sparse(..)
            | Stepping::Midpoint(_)
            | Stepping::Large(_) => {
                unreachable!("`choose` refuses flows that the mechanism cannot have")
            }
        }
    }

    /// The equations.
    pub fn system(&self) -> &S {
        &self.context.system
    }

    /// (κ₁ + κ₂)/h of the last step, over all stages: the mean forces of the rows; `None` before the first step.
    pub(crate) fn multipliers(&self) -> Option<SVector<f64, R>> {
        let impulse = match (self.stages.len(), &self.extrapolation) {
            (1, None) => {
                let [first, second] = &self.context.work.impulse;
                added(first, 1.0, second)
            }
            _ => self.impulse,
        };
        (self.length != 0.0).then(|| vector(|i| impulse[i] / self.length))
    }

    /// The current state.
    pub fn state(&self) -> &State<Q, N, R> {
        &self.context.state
    }

    /// The flow in use.
    pub fn flow(&self) -> Flow {
        match self.flow {
            Stepping::Leapfrog(_) | Stepping::Sparse(..) => Flow::Leapfrog,
            Stepping::Midpoint(_) => Flow::Midpoint,
            Stepping::Trapezoid(_) => Flow::Trapezoid,
            Stepping::Implicit(..) | Stepping::Large(_) => Flow::Implicit,
        }
    }

    pub(crate) fn counters(&self) -> Counters {
        self.context.counters
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> fmt::Debug
    for TwoLevelStepper<S, Q, N, R>
{
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("TwoLevelStepper")
            .field("mechanism", &S::MODEL.name)
            .field("state", &self.context.state)
            .finish_non_exhaustive()
    }
}
