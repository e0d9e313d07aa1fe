//! Steps chosen by a tolerance ([`Settings::tolerance`](crate::Settings::tolerance)).
//!
//! Steps come in pairs. Each pair is compared with other steps over the same time, as a rule with a single one: where both steps
//! are h, one of 2h and order p has 2ᵖ times the error e of the pair, so that the two differ by (2ᵖ − 1) e. The pair is kept where
//!
//! ```text
//! e ≤ share · tolerance · max(|Δq|, T · greatest speed so far)
//! ```
//!
//! with T the time of the pair, and ½ T |Δv| counted like Δq; the round-off of either is allowed. The length h stays the same until
//! one comparison requires a shorter one, or several in a row allow a longer one: a symmetric method keeps its long-time behaviour as long as its step
//! length does not follow the motion (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, section VIII.1). Lengths are
//! powers of 2^¼ times the first one.
//!
//! Not every pair is compared: a comparison tells by which factor an estimate from the stages differs from the error, and the
//! pairs that follow use this factor. Where a force may have jumped, a pair is compared (`jumps.rs`).
//!
//! | method | estimate | lengths |
//! |---|---|---|
//! | two-level, orders 4 to 8 | `alf3f/embedded.rs`; where forces depend on velocities, the distance of two means of `alf3f/extrapolation.rs`. It shows only that the motion is still the one of the last comparison: the factor counts for pairs of the same length, and no pair is rejected without a comparison | constant |
//! | explicit, Radau | embedded method | follow the motion (`step_controller.rs`), of explicit methods in each step: they are not symmetric, and gain nothing by constant steps |
//!
//! If the steps of a comparison end beside a singular pose, they have an additional error. It is then made with two
//! unequal steps, and after these with a shorter pair.
//!
//! Where less than a step of one of the latter is left, a single step is taken (`lone_step.rs`).
//!
//! A pair that leaps over a pose that is nearly singular is not kept, though its error seems small (`passage.rs`).

use super::Simulation;
use super::books::Books;
use super::jumps::Previous;
use super::pose::Passage;
use super::step_controller::{Pace, TOO_LONG, notches};
use crate::{Energy, ErrorOf, Method, SimulationError, StepController, System};

/// Lengths of pairs, as fractions of h, that are tried if a singular pose spoils every comparison.
const SIDESTEPS: [f64; 4] = [1.0, 0.84, 0.71, 0.59];
/// Where σ is below this, velocities have errors from the pose that no shorter step removes. After so many attempts from one
/// instant, and each further one, this factor more of round-off is allowed, and the error of the first pair that was tried. (Up
/// to 20 times the round-off that is expected was found, at σ = 6e-4.)
const BESIDE: f64 = 0.02;
const ATTEMPTS: u32 = 3;
const INDULGENCE: [f64; 2] = [4.0, 64.0];
/// Steps shorter than this part of the first one that may be tried are not, …
pub(super) const SHORTEST: f64 = 1e-9;
/// … nor those shorter than this part of the time, of which the clock counts some fifty parts.
pub(super) const CLOCK: f64 = 1e-14;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The step in use, s.
    pub(super) fn nominal(&self) -> f64 {
        match self.settings.tolerance {
            Some(_) if self.state().step_controller.step > 0.0 => self.state().step_controller.step,
            _ => self.settings.step,
        }
    }

    /// A step of h or, with a tolerance, a pair of what it calls for; `left` at most.
    pub(super) fn forward(&mut self, h: f64, left: f64) -> Result<(), SimulationError> {
        let Some(tolerance) = self.settings.tolerance else {
            return self.given_step(h, left);
        };
        let moved = match self.other {
            Some(other) if self.choice.is_some() => (other.pair)(self, tolerance, left),
            _ => self.pair(tolerance, left).map(drop),
        };
        if moved.is_err() {
            // Those of its trials are no answer.
            self.multipliers_before = Some(None);
            self.balance = self.energy();
        }
        moved
    }

    /// Two steps, the first of h, and shorter ones until their error is small enough.
    pub(super) fn pair(&mut self, tolerance: f64, left: f64) -> Result<Passage, SimulationError> {
        let mut step_controller = self.state().step_controller;
        if step_controller.step == 0.0 {
            step_controller = StepController::starting(self.settings.step);
        }
        let previous = Previous::of(&step_controller);
        let (books, balance) = (self.books, self.balance);
        self.pair_start.copy_from(self.integrator.state());
        let margin = self.margin();
        let clock = CLOCK * self.pair_start.time.abs();
        let shortest = clock.max(SHORTEST * self.settings.step.min(0.5 * left));
        if self.may_be_lone(left, &step_controller, margin) {
            let controller = (&step_controller, previous, margin);
            let found = self.lone_step(tolerance, left, controller)?;
            if let Some(found) = found
                && self.imbalance(tolerance, &balance, &found, shortest) <= 1.0
            {
                step_controller.speed = step_controller.speed.max(found.speed);
                step_controller.note(None, found.error_ratio, None);
                step_controller.see(found.estimated_difficulty);
                self.integrator.state_mut().step_controller = step_controller;
                return Ok(found.passage);
            }
            self.begin_pair_again(books, balance)?;
        }
        let (mut sidestep, mut attempts, mut reach) = (0, 0, 0.0);
        loop {
            let h = SIDESTEPS[sidestep] * step_controller.step.min(0.5 * left);
            let last = sidestep + 1 == SIDESTEPS.len();
            match attempts {
                0 => reach = 2.0 * h,
                // A shorter attempt is no remainder, which is not placed.
                _ => self.integrator.state_mut().step_controller.step = step_controller.step,
            }
            let persists = attempts >= ATTEMPTS && margin.least < BESIDE;
            let allowance = if persists {
                let more = INDULGENCE[0].powi((attempts - ATTEMPTS + 1) as i32);
                (reach, more.min(INDULGENCE[1]))
            } else {
                (0.0, 1.0)
            };
            let controller = (&step_controller, previous, margin);
            let found = self.compare(
                tolerance,
                (h, left),
                allowance,
                controller,
                (shortest, last),
            );
            let order = self.settings.true_order();
            let (error_ratio, is_embedded, error) = match found {
                Ok(mut found) => {
                    if found.error_ratio <= 1.0 && self.leaps(&found.passage)? {
                        (found.error_ratio, found.of) = (TOO_LONG, ErrorOf::Branch);
                    }
                    if found.error_ratio <= 1.0 {
                        let imbalance = self.imbalance(tolerance, &balance, &found, shortest);
                        if imbalance > found.error_ratio {
                            (found.error_ratio, found.of) = (imbalance, ErrorOf::Balance);
                            (found.parts, found.difficulty_of_first) = (None, None);
                        }
                    }
                    if found.error_ratio <= 1.0 {
                        step_controller.speed = step_controller.speed.max(found.speed);
                        step_controller.still_pairs = match (found.is_paced, found.is_apart) {
                            (true, _) => 0,
                            (false, is_apart) => step_controller.still_pairs + u32::from(is_apart),
                        };
                        // The last pair of a run, which is shorter than others.
                        let is_rest = h < step_controller.step && h == 0.5 * left;
                        if h == step_controller.step || is_rest && self.follows() {
                            step_controller.see(found.estimated_difficulty);
                        }
                        // Its error is mostly round-off, and does not lower the factor.
                        let least = if is_rest {
                            step_controller.estimate_factor
                        } else {
                            0.0
                        };
                        step_controller.note(
                            found.estimate_factor.map(|factor| factor.max(least)),
                            match found.is_round_off {
                                true => 0.0,
                                false => found.error_ratio,
                            },
                            self.follows().then(|| self.pace()),
                        );
                        step_controller.remember();
                        step_controller.see_states(found.of_states);
                        if h == step_controller.step && found.is_embedded && self.follows() {
                            let errors = (found.error_ratio, found.parts);
                            step_controller.follow_pair(
                                order,
                                found.passage.steps,
                                errors,
                                found.difficulty_of_first,
                                self.pace(),
                            );
                        } else if is_rest && found.is_embedded && self.follows() {
                            step_controller.reach_out(order, h, found.error_ratio, self.pace());
                        } else if h == step_controller.step && found.as_chosen && !self.follows() {
                            step_controller.lengthen(notches(order, found.error_ratio));
                        }
                        self.integrator.state_mut().step_controller = step_controller;
                        return Ok(found.passage);
                    }
                    let error = SimulationError::Tolerance {
                        time: self.pair_start.time,
                        step: h,
                        tolerance,
                        times: found.error_ratio,
                        of: found.of,
                    };
                    (found.error_ratio, found.is_embedded, error)
                }
                Err(error) if error.is_due_to_steps() => (TOO_LONG, false, error),
                Err(error) => return Err(error),
            };
            self.begin_pair_again(books, balance)?;
            if error_ratio.is_nan() && !last {
                sidestep += 1;
                continue;
            }
            sidestep = 0;
            let error_ratio = if error_ratio.is_nan() {
                TOO_LONG
            } else {
                error_ratio
            };
            let is_judged_by_factor = step_controller.estimate_factor > 0.0;
            match is_embedded && self.follows() {
                true => step_controller.retreat(order, h, error_ratio, (attempts > 0, self.pace())),
                false => step_controller.shorten(h, notches(order, error_ratio)),
            }
            attempts += 1;
            if !(step_controller.step > shortest) {
                // The shortest one may do where the next one would not be tried, or where the estimate alone rejects.
                if !(h > 2.0 * shortest || is_judged_by_factor) {
                    return Err(error);
                }
                (step_controller.step, step_controller.estimate_factor) = (1.5 * shortest, 0.0);
            }
        }
    }

    /// After steps that are not kept.
    fn begin_pair_again(&mut self, books: Books, balance: Energy) -> Result<(), SimulationError> {
        self.rejected += 1;
        self.integrator.state_mut().copy_from(&self.pair_start);
        (self.books, self.rank_margin, self.balance) = (books, None, balance);
        self.integrator.refresh(&self.settings)
    }

    /// Whether steps are controlled by the estimates of an embedded method. A step that fails is then as one whose estimate is
    /// too large: no other lengths are tried, and no halves.
    pub(super) fn is_paced_by_estimates(&self) -> bool {
        self.follows() && self.settings.tolerance.is_some()
    }

    /// Whether rows of time determine the positions: then only works have an error. Rows of velocities do not determine them: these
    /// are integrated. (In long two-level steps the work of drives is right for some lengths and far off for others, which only
    /// comparisons show.)
    pub(super) fn is_determined(&self) -> bool {
        (const { Self::DRIVEN && S::STRUCTURE.holonomic_rows == R }) && self.assembly.rank == N
    }

    pub(super) fn pace(&self) -> Pace {
        match self.settings.method {
            Method::Radau => Pace::Kept,
            _ if self.is_determined() => Pace::Erratic,
            // The balance of the work of drives is that of pairs.
            _ if const { Self::DRIVEN } => Pace::Pairs,
            _ => Pace::Steps,
        }
    }

    /// Whether lengths of steps follow the motion: those of methods with an estimate that are not symmetric.
    pub(super) fn follows(&self) -> bool {
        self.is_estimated && !matches!(self.settings.method, Method::TwoLevel)
    }

    /// The mean speed from the beginning of the pair, `length` seconds ago, in sizes and radians a second. It is at least the
    /// speed that both ends have: a body that has turned more than once shows only the rest of its way.
    pub(super) fn speed(&self, length: f64) -> f64 {
        let moved = self
            .system()
            .difference(&self.pair_start.positions, self.positions());
        let [before, now] = [&self.pair_start.velocities, self.velocities()]
            .map(|velocities| self.size(velocities));
        before.min(now).max(self.size(&moved) / length)
    }

    /// The way that the last pair goes, or would have gone with steps as long as those in use, in sizes and radians.
    pub(super) fn way(&self) -> f64 {
        let length = self.time() - self.pair_start.time;
        self.speed(length) * 2.0 * self.nominal()
    }
}
