//! The choice of a method, made again on the way ([`Settings::accuracy`](crate::Settings::accuracy)).
//!
//! A motion may change its character: a block that slides comes to stick, where friction is a stiff damper; a transient ends;
//! an input starts a motor. In smooth motion the way that a pair of steps goes is about the same, fast or slow; where it becomes
//! much shorter or longer and stays so, the candidates are tried again from that state on:
//!
//! ```text
//! pair ─▶ way outside 1/8 to 8 times that at the choice, in 16 pairs in a row? ─▶ trials ─▶ the method with less work
//! ```
//!
//! They are tried, too, where a second of the motion takes more than twice the operations that the trial at the choice has found:
//! it has seen another motion.
//!
//! Trials cost as much as some hundred pairs. The next ones may be made after four times their operations, and later where they
//! have changed nothing: in a periodic motion all of them together are a small part of a long run. Seldom they are made in any
//! case. A trial that would take too much is cut off, and counts with what it has shown up to then. Candidates that were hopeless
//! at the beginning are tried last, and only if no other has shown less work than the method in use.

use super::Simulation;
use super::trial::{GAIN, Trial};
use crate::{Method, MethodChange, SimulationError, StepController, System};

/// The same as [`GAIN`] where Radau is in use: explicit steps would take a hundred times its work where a part of the motion
/// becomes stiff again.
const RETURN: f64 = 0.3;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The changes of the method so far, in the order of time: for an accuracy, if the motion has changed its character.
    pub fn method_changes(&self) -> &[MethodChange] {
        self.choice.as_ref().map_or(&[], |choice| choice.changes())
    }

    /// A pair of steps, with the method that was chosen or with another one if the motion has changed.
    pub(super) fn chosen_pair(&mut self, tolerance: f64, left: f64) -> Result<(), SimulationError> {
        if let Some(most) = self.allowed_trials() {
            self.choose_again(most)?;
        }
        match self.settings.method {
            Method::Radau => self.pair_far_from_poses(tolerance, left),
            _ => self.pair(tolerance, left).map(drop),
        }
    }

    /// A pair of steps of Radau, whose steps are not placed: near a singular pose, or where they cannot go on, another candidate
    /// takes it, and Radau is none from there on.
    fn pair_far_from_poses(&mut self, tolerance: f64, left: f64) -> Result<(), SimulationError> {
        let kept = self.keep();
        match self.pair(tolerance, left) {
            Ok(passage) if passage.is_far_from_poses() => return Ok(()),
            Err(error) if !error.is_due_to_steps() => return Err(error),
            _ => {}
        }
        self.integrator.state_mut().copy_from(&self.pair_start);
        self.restore(kept)?;
        self.leave_candidate()?;
        self.pair(tolerance, left).map(drop)
    }

    #[cold]
    #[inline(never)]
    fn leave_candidate(&mut self) -> Result<(), SimulationError> {
        let left = self.choice.as_ref().map(|choice| choice.current());
        let (best, trial, _) = self.best_other(f64::INFINITY, f64::MAX);
        self.take_candidate(best, [Trial::NONE, trial])?;
        if let (Some(choice), Some(left)) = (&mut self.choice, left) {
            choice.leave_out(left);
        }
        Ok(())
    }

    /// If the method is to be chosen again: the operations that this may take.
    fn allowed_trials(&mut self) -> Option<f64> {
        let way = match self.choice {
            Some(_) => self.way(),
            None => return None,
        };
        let choice = self.choice.as_mut()?;
        if !choice.note(way) {
            return None;
        }
        self.choice.as_ref()?.allowed(self.done(), self.time())
    }

    /// The operations since the choice.
    fn done(&self) -> f64 {
        self.choice.as_ref().map_or(0.0, |choice| {
            choice.work.between(&choice.start().1, &self.report())
        })
    }

    /// Tries the methods from here on, and takes the best one.
    #[cold]
    #[inline(never)]
    fn choose_again(&mut self, most: f64) -> Result<(), SimulationError> {
        let now = (self.time(), self.report());
        let Some(choice) = &self.choice else {
            return Ok(());
        };
        let gain = match self.settings.method {
            Method::Radau => RETURN,
            _ => GAIN,
        };
        // What is hard for both, as where a block slips for a moment, says nothing about the rest.
        let enough = gain * self.done() / (now.0 - choice.start().0);
        let (best, other, mut spent) = self.best_other(most, enough);
        let mut current = Trial::NONE;
        if other.rate.is_finite() {
            let mut run = self.clone();
            run.choice = None;
            current = run.run_beside(&other);
            spent += current.operations;
        }
        let is_better = other.rate < gain * current.rate;
        let is_less = other.rate.min(other.mean_rate(now.0)) < enough;
        if is_better && (is_less || !current.has_run()) {
            return self.take_candidate(best, [current, other]);
        }
        if let Some(choice) = &mut self.choice {
            match other.rate.is_finite() && current.rate.is_finite() {
                true => choice.stay(now, spent, current.character(), !is_better),
                // One of them fails, or needs a longer trial: the motion stays unlike that at the choice.
                false => choice.stay(now, most, choice.character(), true),
            }
        }
        Ok(())
    }

    /// The best of the candidates that are not in use, its trial, and the operations of all trials, at most `most`. If none can
    /// go on, it is the last of them. One that was hopeless is not tried if another one has at most the rate `enough`.
    fn best_other(&self, most: f64, enough: f64) -> (usize, Trial, f64) {
        let Some(choice) = &self.choice else {
            return (0, Trial::NONE, 0.0);
        };
        let others = choice.others();
        let (mut best, mut leader, mut spent) = (others.iter().copied().max(), Trial::NONE, 0.0);
        for candidate in others {
            let is_enough = leader.rate <= enough && choice.is_hopeless(candidate);
            if is_enough || spent >= most {
                break;
            }
            let trial = (self.with_candidate(candidate))
                .map_or(Trial::NONE, |mut run| run.run_trial(most - spent, &leader));
            if trial.operations.is_finite() {
                spent += trial.operations.min(most - spent);
            }
            if trial.rate < leader.rate {
                (best, leader) = (Some(candidate), trial);
            }
        }
        (best.unwrap_or(0), leader, spent)
    }

    /// A simulation with this candidate from here on.
    fn with_candidate(&self, candidate: usize) -> Result<Self, SimulationError> {
        let mut settings = self.settings;
        if let Some(choice) = &self.choice {
            settings = choice.settings_of(candidate);
        }
        let mut state = self.state().clone();
        state.forget_factors();
        state.step_controller = StepController {
            speed: state.step_controller.speed,
            // A longer step may be too long for a stop that the method in use has just met.
            ..StepController::starting(settings.step.min(self.nominal()))
        };
        let (system, assembly) = (self.system().clone(), self.assembly.clone());
        Self::from_state(system, settings, state, assembly, self.other)
    }

    fn take_candidate(
        &mut self,
        candidate: usize,
        [before, after]: [Trial; 2],
    ) -> Result<(), SimulationError> {
        let mut renewed = self.with_candidate(candidate)?;
        let change = MethodChange {
            time: self.time(),
            before: self.settings.method,
            method: renewed.settings.method,
            order: renewed.settings.true_order(),
            operations: [before.rate, after.rate],
        };
        let now = (self.time(), self.report());
        if let Some(choice) = &mut self.choice {
            choice.change(
                candidate,
                now,
                (after.operations, after.character()),
                change,
            );
            choice.work = renewed.work();
        }
        renewed.take_over_motion(self);
        *self = renewed;
        Ok(())
    }
}
