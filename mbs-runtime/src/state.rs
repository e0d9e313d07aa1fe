//! The state of a simulation: all data to continue it bit for bit.

#[cfg(feature = "sparse")]
mod backward_differences;
#[cfg(feature = "sparse")]
mod factor_origin;
#[cfg(feature = "std")]
mod known_poses;
mod poses_ahead;

#[cfg(feature = "sparse")]
use crate::large::is_large;
use crate::linear::{entries, entries_mut, vector};
#[cfg(feature = "sparse")]
use crate::memory::Box;
use crate::memory::StageList;
use crate::row_scale::RowScale;
use crate::singular::{USUAL_GROWTH, USUAL_GROWTH_WEAK};
#[cfg(feature = "std")]
use crate::{SimulationError, System};
#[cfg(feature = "sparse")]
pub use backward_differences::BackwardDifferences;
#[cfg(feature = "sparse")]
pub(crate) use factor_origin::COST;
#[cfg(feature = "sparse")]
pub use factor_origin::{FactorOrigin, Renewal};
#[cfg(feature = "std")]
pub use known_poses::KnownPoses;
use nalgebra::SVector;
pub use poses_ahead::{Foreseen, LastStep, PosesAhead};

/// The round-off of a time, s.
#[cfg(feature = "std")]
pub(crate) fn rounding(time: f64) -> f64 {
    4.0 * f64::EPSILON * time.abs()
}

/// Whether a step of h is as long as an earlier one, which is zero if there was none.
#[cfg(feature = "sparse")]
fn is_equal(step: f64, h: f64) -> bool {
    step != 0.0 && (step - h).abs() <= 1e-6 * h.abs()
}

/// The state of a simulation; plain data, so that it can be kept, compared and resumed from.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State<const Q: usize, const N: usize, const R: usize> {
    /// Time, s.
    pub time: f64,
    /// What the rounding of `time` has left out, s; the next step makes up for it, so that steps are counted exactly.
    pub clock: f64,
    /// q.
    pub positions: SVector<f64, Q>,
    /// v.
    pub velocities: SVector<f64, N>,
    /// κ₁/h of the last step, a force: the start of the iteration in the next step …
    pub multipliers: SVector<f64, R>,
    /// … plus its change from the step before.
    pub multiplier_changes: SVector<f64, R>,
    /// The same two, stage by stage, of the last step of a composition; empty for second order.
    pub stage_multipliers: StageList<[SVector<f64, R>; 2]>,
    /// The inputs, in the order and units of [`Model::inputs`](crate::Model::inputs), which `resume` gives to the mechanism; if this is
    /// empty, it has those that are declared. Steppers that are given a system have its inputs. (Without the feature `std` a state has
    /// no inputs.)
    #[cfg(feature = "std")]
    #[cfg_attr(feature = "serde", serde(default))]
    pub inputs: Vec<f64>,
    /// Accumulated work.
    pub ledger: Ledger,
    /// Data of the step controller, for runs with a tolerance.
    pub step_controller: StepController,
    /// The fields that only Algorithm 1 carries from step to step.
    pub fields: ThreeFields<N, R>,
    /// What steps of fixed length know of singular poses.
    #[cfg_attr(feature = "serde", serde(default))]
    pub poses_ahead: PosesAhead,
    /// Singular poses that have been looked at.
    #[cfg(feature = "std")]
    #[cfg_attr(feature = "serde", serde(default))]
    pub known_poses: KnownPoses<Q>,
    /// Where the factors in use were made, of a large mechanism; otherwise `None`.
    #[cfg(feature = "sparse")]
    #[cfg_attr(feature = "serde", serde(default))]
    pub factors: Option<Box<FactorOrigin<Q, N>>>,
    /// What its steps begin their corrections with.
    #[cfg(feature = "sparse")]
    #[cfg_attr(feature = "serde", serde(default))]
    pub differences: Option<Box<BackwardDifferences<N>>>,
}

impl<const Q: usize, const N: usize, const R: usize> State<Q, N, R> {
    /// Gives a system the inputs of this state, if it has any.
    #[cfg(feature = "std")]
    pub(crate) fn give_inputs<S: System<Q, N, R>>(
        &self,
        system: &mut S,
    ) -> Result<(), SimulationError> {
        let inputs = system.inputs_mut();
        let refuse = |what, value| Err(SimulationError::State { what, value });
        if self.inputs.is_empty() {
            return Ok(());
        }
        if self.inputs.len() != inputs.len() {
            return refuse("the number of inputs", self.inputs.len() as f64);
        }
        if let Some(&value) = self.inputs.iter().find(|value| !value.is_finite()) {
            return refuse("an input", value);
        }
        inputs.copy_from_slice(&self.inputs);
        Ok(())
    }

    /// The impulses κ₁ that a step of h begins with.
    #[inline(always)]
    pub(crate) fn expected_impulse(&self, h: f64) -> SVector<f64, R> {
        let (now, change) = (
            entries(&self.multipliers),
            entries(&self.multiplier_changes),
        );
        vector(|i| h * (now[i] + change[i]))
    }

    /// Keeps the impulses κ₁ of a step of h for the next one.
    ///
    /// Beside a singular pose (`weak`) a step can have very large multipliers along a direction that has no effect
    /// there but a large effect in the next step. With these as start, Newton's method may converge to another branch.
    /// Multipliers that jump are therefore dropped: the next step begins with zero.
    #[inline(always)]
    pub(crate) fn keep_impulse(
        &mut self,
        h: f64,
        impulse: &SVector<f64, R>,
        weak: bool,
        scale: &RowScale<R>,
    ) {
        let rate = 1.0 / h;
        let before = scale.square(&self.multipliers);
        let now = rate * rate * scale.square(impulse);
        let usual = if weak {
            USUAL_GROWTH_WEAK
        } else {
            USUAL_GROWTH
        };
        if now > usual * before && (weak || before > 0.0) {
            self.multipliers = SVector::zeros();
            self.multiplier_changes = SVector::zeros();
            return;
        }
        let now = entries_mut(&mut self.multipliers);
        let change = entries_mut(&mut self.multiplier_changes);
        let impulse = entries(impulse);
        for i in 0..R {
            let force = rate * impulse[i];
            change[i] = force - now[i];
            now[i] = force;
        }
    }

    /// The time after a step of h, as [`Self::count`] sets it.
    #[inline(always)]
    pub(crate) fn end_of(&self, h: f64) -> f64 {
        self.time + (h + self.clock)
    }

    /// Sets the time h seconds after `start`, where it was `clock` behind: compensated summation.
    #[inline]
    pub(crate) fn count(&mut self, (start, clock): (f64, f64), h: f64) {
        let passed = h + clock;
        self.time = start + passed;
        self.clock = passed - (self.time - start);
    }

    /// Prepares for steps of this many stages.
    pub(crate) fn make_room(&mut self, stages: usize) {
        if stages == 1 || self.stage_multipliers.len() != stages {
            self.stage_multipliers.clear();
        }
        if stages > 1 {
            self.stage_multipliers.reserve(stages);
        }
    }

    /// Makes room for the origin of factors and for differences, where steps keep any.
    #[cfg(feature = "sparse")]
    pub(crate) fn keep_factors(&mut self, keep: bool) {
        if !keep {
            (self.factors, self.differences) = (None, None);
            return;
        }
        self.factors
            .get_or_insert_with(|| Box::new(FactorOrigin::none()));
        self.differences
            .get_or_insert_with(|| Box::new(BackwardDifferences::none()));
    }

    /// The next step of a large mechanism makes new factors: an input has changed, which the origin of factors does not have.
    pub(crate) fn forget_factors(&mut self) {
        #[cfg(feature = "sparse")]
        if let Some(factors) = &mut self.factors {
            factors.step = 0.0;
        }
    }

    /// A copy with room for the same stages.
    pub(crate) fn with_same_room(&self) -> Self {
        let mut copy = self.clone();
        #[cfg(feature = "std")]
        copy.known_poses.make_room(false);
        let room = self.stage_multipliers.capacity();
        copy.stage_multipliers
            .reserve(room - self.stage_multipliers.len());
        copy
    }

    /// The same on the heap; here, so that the copy is on the stack only while it is made.
    #[inline(never)]
    pub(crate) fn boxed_copy(&self) -> crate::memory::Box<Self> {
        crate::memory::Box::new(self.with_same_room())
    }

    /// Copies `other`, without allocation if the capacity is sufficient; not what is known of poses, which steps that are
    /// taken back have found, too, and not the inputs, which no step changes.
    #[inline]
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.copy_motion_from(other);
        self.step_controller = other.step_controller;
        self.fields = other.fields;
    }

    /// The same without what a step of the two-level and of the projected method leaves as it is.
    #[inline]
    pub(crate) fn copy_motion_from(&mut self, other: &Self) {
        (self.time, self.clock) = (other.time, other.clock);
        self.positions = other.positions;
        self.velocities = other.velocities;
        self.multipliers = other.multipliers;
        self.multiplier_changes = other.multiplier_changes;
        if !(self.stage_multipliers.is_empty() && other.stage_multipliers.is_empty()) {
            self.stage_multipliers.clone_from(&other.stage_multipliers);
        }
        self.ledger = other.ledger;
        #[cfg(feature = "sparse")]
        if const { is_large::<N, R>() } {
            self.factors.clone_from(&other.factors);
            self.differences.clone_from(&other.differences);
        }
    }

    /// The multipliers that a stage begins with: its own of the last step, in the first step those of the stage before.
    #[inline]
    pub(crate) fn recall_stage(&mut self, stage: usize) {
        match self.stage_multipliers.get(stage) {
            Some(&[multipliers, changes]) => {
                self.multipliers = multipliers;
                self.multiplier_changes = changes;
            }
            None => self.multiplier_changes = SVector::zeros(),
        }
    }

    /// Keeps the multipliers of a stage for the next step.
    #[inline]
    pub(crate) fn keep_stage(&mut self, stage: usize) {
        match self.stage_multipliers.get_mut(stage) {
            Some(kept) => *kept = [self.multipliers, self.multiplier_changes],
            None => self
                .stage_multipliers
                .push([self.multipliers, SVector::zeros()]),
        }
    }

    /// A state without history.
    pub fn new(time: f64, positions: SVector<f64, Q>, velocities: SVector<f64, N>) -> Self {
        State {
            time,
            clock: 0.0,
            positions,
            velocities,
            multipliers: SVector::zeros(),
            multiplier_changes: SVector::zeros(),
            stage_multipliers: StageList::new(),
            #[cfg(feature = "std")]
            inputs: Vec::new(),
            ledger: Ledger::default(),
            step_controller: StepController::default(),
            fields: ThreeFields::default(),
            poses_ahead: PosesAhead::default(),
            #[cfg(feature = "std")]
            known_poses: KnownPoses::none(),
            #[cfg(feature = "sparse")]
            factors: None,
            #[cfg(feature = "sparse")]
            differences: None,
        }
    }
}

/// Data of the energy balance, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ledger {
    /// T + V where the balance starts; `None` until a simulation has taken it.
    pub initial: Option<f64>,
    /// Work of the applied forces without potential.
    pub nonconservative_work: f64,
    /// Work of the rheonomic rows.
    pub drive_work: f64,
    /// What the motion has had, by which errors of the balance are judged; `None` until a simulation has taken it.
    pub range: Option<EnergyRange>,
}

/// What a motion has had since its balance began, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EnergyRange {
    /// What the forces at the start give along the size of the mechanism, or up to where a linear force vanishes.
    pub depth: f64,
    /// The smaller of the least potential energy so far and that at the start less `depth`.
    pub least: f64,
    /// The largest works so far.
    pub works: f64,
    /// The sum of the squared doubts about the works of forces in the steps so far, J²: their errors have either sign where a
    /// power oscillates, and are few where a brake stops a part. Their sum would grow with the length of any run until
    /// nothing is refused.
    pub doubts: f64,
    /// The sum of the works of all steps without their signs: what forces and drives have given and taken back.
    pub exchanged: f64,
}

/// Data of the step controller, kept from step to step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StepController {
    /// The step in use, s; zero: none was chosen yet.
    pub step: f64,
    /// Comparisons in a row that would have allowed a longer step …
    pub quiet: u32,
    /// … and the growth that all of them allow, in powers of 2^¼.
    pub allowed: f64,
    /// The number of comparisons that is required.
    pub patience: u32,
    /// Whether the last change was to a longer step.
    pub raised: bool,
    /// Whether the first step length has not been found yet.
    pub searching: bool,
    /// The greatest speed so far, in sizes of the mechanism and radians a second.
    pub speed: f64,
    /// The error of a pair by comparison, as a multiple of the estimate by an embedded method; zero: not known.
    pub estimate_factor: f64,
    /// Pairs since the last comparison.
    pub pairs_since_comparison: u32,
    /// log₂ of what the error ratio of the last pair, or of its last step, by an embedded method would be with steps of a second. With
    /// states the largest of the last pairs, of states, by comparison.
    #[cfg_attr(feature = "serde", serde(default))]
    pub difficulty: Option<f64>,
    /// The same of the last pair of the chosen length by the estimate alone, without its factor.
    #[cfg_attr(feature = "serde", serde(default))]
    pub estimated_difficulty: Option<f64>,
    /// Powers of 2 by which errors are aimed below the usual aim, after pairs that were too long.
    #[cfg_attr(feature = "serde", serde(default))]
    pub caution: f64,
    /// Pairs from rest whose way is round-off, in very short steps, since the last pair in longer ones.
    #[cfg_attr(feature = "serde", serde(default))]
    pub still_pairs: u32,
    /// The length of the longest steps of late, s; zero: no pair was kept yet.
    #[cfg_attr(feature = "serde", serde(default))]
    pub usual: f64,
}

/// λ, μ, π, σ of the three-field formulation, (26)–(31), and the step in use.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ThreeFields<const N: usize, const R: usize> {
    /// λ.
    pub lambda: SVector<f64, R>,
    /// μ = λ̇.
    pub mu: SVector<f64, R>,
    /// π = M v − Aᵀ m̄ μ, (26).
    pub momentum: SVector<f64, N>,
    /// σ = m̄ ψ̇, (27).
    pub constraint_momentum: SVector<f64, R>,
    /// The step in use, s, after halvings; zero stands for the nominal one.
    pub step: f64,
    /// The shortest step in use within the last nominal one, s.
    pub shortest: f64,
    /// ξ, the penalties at the end of the last step.
    pub penalty: SVector<f64, R>,
    /// μ₁ − μ₀ over the last accepted step (λ₁ − λ₀ of M-ALF), which the next one begins its iteration with, …
    pub change: SVector<f64, R>,
    /// … and the length of that step, s; zero: there was none.
    pub length: f64,
    /// Whether λ, μ and π hold values of a previous step.
    pub started: bool,
}

impl<const N: usize, const R: usize> Default for ThreeFields<N, R> {
    fn default() -> Self {
        ThreeFields {
            lambda: SVector::zeros(),
            mu: SVector::zeros(),
            momentum: SVector::zeros(),
            constraint_momentum: SVector::zeros(),
            step: 0.0,
            shortest: 0.0,
            penalty: SVector::zeros(),
            change: SVector::zeros(),
            length: 0.0,
            started: false,
        }
    }
}
