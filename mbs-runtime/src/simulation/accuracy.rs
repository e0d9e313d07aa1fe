//! A method for an accuracy ([`Settings::accuracy`](crate::Settings::accuracy)): each candidate runs the beginning of the
//! motion, and the one with the least operations for a second of it is taken.
//!
//! | candidate | where it has the least |
//! |---|---|
//! | two-level with a tolerance | free rotations, many rows, stiff springs |
//! | Radau with a tolerance | stiff dampers, friction |
//! | explicit, projected, with a tolerance | most others: no Newton iteration in its stages |
//!
//! The explicit one begins, as its trials take the least. If another one is hopeless beside it, that is all; otherwise
//! both are counted over the same time, so that they see the same motion: where a stop or a spring makes a part of it stiff,
//! few steps of the one may go as far as many of the other. An earlier one is kept only with fewer operations in the last part
//! of this time and in all of it. Operations are counted, not timed, so that the choice is the same
//! in every run. It is made again where the motion has changed (`revision.rs`).
//!
//! Radau is a candidate where forces depend on velocities: it damps the vibration of stiff springs, which the two-level method
//! does not. Its matrices are dense, so that it serves small mechanisms.

use super::Simulation;
use super::choice::{Candidate, Choice};
use super::other_methods::OtherMethods;
use super::trial::{GAIN, Trial};
use crate::baselines::registry::has_radau;
use crate::methods::Methods;
use crate::{AssemblyVerdict, Method, Settings, SimulationError, State, StepController, System};

/// Accuracy over tolerance: errors of steps add up and grow with the motion's own instability. On the scenes with
/// a reference the largest error was up to 23 tolerances with steps of the projected method, and 31 with two-level ones.
const MARGIN: f64 = 5.0;

/// A shorter way of the pairs of a trial, in sizes and radians, is round-off of a mechanism at rest.
const RESTING: f64 = 1e-12;

/// The candidates in the order of their trials.
fn candidates(settings: Settings, accuracy: f64, has_radau: bool) -> Vec<Settings> {
    let two_level = two_level(settings, accuracy);
    let projected = Settings {
        method: Method::Projected,
        order: 8,
        ..two_level
    };
    let radau = Settings {
        method: Method::Radau,
        order: 2,
        ..two_level
    };
    match has_radau {
        true => vec![projected, radau, two_level],
        false => vec![projected, two_level],
    }
}

/// The candidate that every program has.
fn two_level(settings: Settings, accuracy: f64) -> Settings {
    let tolerance = (accuracy / MARGIN).max(Settings::LEAST_TOLERANCE);
    Settings {
        accuracy: None,
        ..settings.with_tolerance(tolerance)
    }
}

/// Another candidate is preferred to this one only with less than this part of its operations for a second: motions with
/// friction and stiff dampers become stiff now and then, where others take many times the work of Radau.
fn lead(candidate: Settings) -> f64 {
    match candidate.method {
        Method::Radau => GAIN,
        _ => 1.0,
    }
}

/// The candidate with a first step no longer than that of another one, if the motion sets that length: attempts with steps
/// that are much too long take the most of a trial.
fn shortened(candidate: Settings, other: &Trial) -> Settings {
    let step = match other.follows_the_motion() {
        true => candidate.step.min(other.step),
        false => candidate.step,
    };
    Settings { step, ..candidate }
}

impl<S, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R>
where
    S: System<Q, N, R> + Clone,
{
    /// The functions for the methods of `C`.
    pub(super) fn other_methods<C: Methods>() -> Option<&'static OtherMethods<Self, S, Q, N, R>> {
        const {
            Some(&OtherMethods {
                make: C::make,
                choose: Self::chosen,
                pair: Self::chosen_pair,
            })
        }
    }

    /// With the given method or, for an accuracy, with the candidate that takes the least work; with the two-level method if
    /// there is nothing to choose from.
    pub(super) fn begin(
        system: S,
        settings: Settings,
        state: State<Q, N, R>,
        assembly: AssemblyVerdict,
        other: Option<&'static OtherMethods<Self, S, Q, N, R>>,
    ) -> Result<Self, SimulationError> {
        let mut settings = settings;
        if let Some(accuracy) = settings.accuracy {
            if let Some(other) = other {
                return (other.choose)(system, (settings, accuracy), state, assembly, other);
            }
            settings = two_level(settings, accuracy);
        }
        Self::from_state(system, settings, state, assembly, other)
    }

    /// With the candidate for an accuracy that takes the least work from this state on.
    pub(super) fn chosen(
        system: S,
        (settings, accuracy): (Settings, f64),
        state: State<Q, N, R>,
        assembly: AssemblyVerdict,
        other: &'static OtherMethods<Self, S, Q, N, R>,
    ) -> Result<Self, SimulationError> {
        let candidates = candidates(settings, accuracy, const { has_radau::<S, Q, N, R>() });
        let last = candidates.len() - 1;
        // Steps, factors and difficulties of a state belong to the method that it comes from.
        let mut state = state;
        state.step_controller = StepController {
            speed: state.step_controller.speed,
            ..StepController::default()
        };
        let other = Some(other);
        let make = |candidate| {
            let (system, state, assembly) = (system.clone(), state.clone(), assembly.clone());
            Self::from_state(system, candidate, state, assembly, other)
        };
        // If none can begin here, the two-level one says why.
        let (mut second, mut best, mut leader) = (last, last, Trial::NONE);
        let (begin, mut trials) = (state.time, Vec::with_capacity(candidates.len()));
        for (index, &candidate) in candidates.iter().enumerate() {
            // A candidate that cannot begin here is none.
            let trial = make(shortened(candidate, &leader))
                .map_or(Trial::NONE, |mut run| run.run_trial(f64::INFINITY, &leader));
            trials.push(trial);
            if !trial.rate.is_finite() {
                continue;
            }
            if leader.rate.is_finite() {
                let beside = Self::trial_beside(&make, candidates[best], &trial);
                let [before, after] = [candidates[best], candidates[index]].map(lead);
                let is_less = |rate: f64, other: f64| before * rate < after * other;
                if is_less(beside.rate, trial.rate)
                    && is_less(beside.mean_rate(begin), trial.mean_rate(begin))
                {
                    leader = beside;
                    continue;
                }
            }
            (second, best, leader) = (best, index, trial);
        }
        // Radau has seen another part of the motion than the two-level method where both were compared with the explicit one.
        let damps = |index: usize| candidates[index].method == Method::Radau;
        let radau = (0..last).find(|&index| damps(index) && trials[index].has_run());
        if let Some(radau) = radau.filter(|_| best == last && !damps(second)) {
            let beside = Self::trial_beside(&make, candidates[radau], &leader);
            if lead(candidates[radau]) * beside.rate < leader.rate {
                (best, leader) = (radau, beside);
            }
        }
        let mut simulation = Self::from_state(system, candidates[best], state, assembly, other)?;
        // Long steps of Radau are those after a transient of the beginning, and at rest steps grow without end.
        let moves = leader.rate.is_finite() && leader.way > RESTING;
        if moves && candidates[best].method != Method::Radau {
            let controller = &mut simulation.integrator.state_mut().step_controller;
            *controller = StepController {
                speed: controller.speed,
                ..StepController::after_trial(leader.step, leader.estimate_factor)
            };
        }
        let tried = candidates.iter().zip(&trials);
        let tried = tried.map(|(&settings, trial)| Candidate {
            settings,
            is_hopeless: trial.is_hopeless(),
        });
        // Not the trial of the leader: in a steady motion this may be far longer than those of the others, and the motion may change
        // soon.
        let operations = trials.iter().map(|trial| trial.operations);
        let choice = Choice::new(
            tried.collect(),
            best,
            simulation.work(),
            simulation.time(),
            (
                operations.fold(leader.operations, f64::min),
                leader.character(),
            ),
        );
        simulation.choice = Some(Box::new(choice));
        Ok(simulation)
    }

    /// The trial of a candidate in the span of another one. Here, so that its simulation is on the stack only while it runs.
    #[inline(never)]
    fn trial_beside(
        make: &dyn Fn(Settings) -> Result<Self, SimulationError>,
        candidate: Settings,
        other: &Trial,
    ) -> Trial {
        make(candidate).map_or(Trial::NONE, |mut run| run.run_beside(other))
    }
}
