//! A random run, and the judgement of it.
//!
//! A run is *lost without a word* if it ends with `Ok`, its error of position is far greater than what the same run
//! with somewhat shorter steps and the order of the method let expect, and its energy balance does not show it.

use crate::case::Case;
use crate::entries::Entry;
use crate::random::Random;
use crate::trusted::Trusted;
use mbs_runtime::SimulationError;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Steps are drawn from a power of ten below the usual one to one above, and a half of each.
const DECADES: f64 = 1.5;
/// Tolerances are drawn from here, as exponents of ten.
const TOLERANCES: [f64; 2] = [-10.0, -3.0];
/// Processor time of a run, roughly, s; its logarithm is drawn.
const BUDGET: [f64; 2] = [2e-3, 4e-2];
/// An error of position below this, in sizes and radians, is none.
const NONE: f64 = 1e-6;
/// The factor by which the doubt about the motion is enlarged.
const DOUBTFUL: f64 = 100.0;
/// The factor by which an error exceeds the expected one.
const FAR: f64 = 100.0;
/// The energy balance shows an error of position if its own, relative to the kinetic energy, is at least this part of it.
const SHOWN: f64 = 0.1;
/// Runs with these parts of the step predict the error.
const FINER: [f64; 4] = [0.5, 0.8, 0.64, 0.25];

/// What was drawn.
pub struct Trial {
    /// Its number among those of the mechanism.
    pub number: usize,
    /// The method.
    pub entry: Entry,
    step: f64,
    tolerance: f64,
    /// Whether steps are placed; without it a step may end beside a singular pose.
    pub placement: bool,
    /// The index of the last instant.
    end: usize,
    /// Instants at which the run is interrupted, s.
    pieces: Vec<f64>,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// With an error of position, in sizes and radians, and an error of energy, J.
    Ok { position: f64, energy: f64 },
    /// With an error of this name.
    Stopped(String),
    /// With a panic.
    Panic(String),
}

impl Trial {
    /// Draws a run among the methods that accept the mechanism.
    pub fn draw(
        case: &Case,
        trusted: &Trusted,
        accepted: &[Entry],
        seed: u64,
        number: usize,
    ) -> Self {
        let random = &mut Random::of(&format!("{seed} {} {number}", case.name));
        let shares: usize = accepted.iter().map(|entry| entry.share).sum();
        let mut ticket = random.between(0, shares - 1);
        let chosen = accepted.iter().find(|entry| {
            let mine = ticket < entry.share;
            ticket = ticket.saturating_sub(entry.share);
            mine
        });
        let entry = *chosen.unwrap_or(&accepted[0]);
        let step = case.step * entry.stride() * 10_f64.powf(random.within(DECADES));
        let tolerance = 10_f64.powf(among(random, TOLERANCES));
        let budget = among(random, BUDGET.map(f64::ln)).exp();
        let longest = budget / (entry.stages() * case.stage()) * step;
        let known = trusted.doubt.len();
        let within = trusted.instants[..known].partition_point(|&instant| instant <= longest);
        // A method that chooses its steps is not bound by the first one.
        let most = if entry.tolerant { known } else { within.max(1) };
        // The shortest runs seldom meet anything.
        let least = random.between(0, most - 1);
        let end = random.between(least, most - 1);
        let duration = trusted.instants[end];
        let count = [0, 0, 1, 3, 12][random.between(0, 4)];
        let mut pieces: Vec<f64> = (0..count).map(|_| among(random, [0.0, duration])).collect();
        pieces.sort_by(f64::total_cmp);
        Trial {
            number,
            entry,
            step,
            tolerance,
            placement: random.between(0, 1) == 1,
            end,
            pieces,
        }
    }

    /// Runs it with a part of its step (of its tolerance the square of that).
    pub fn run(&self, case: &Case, trusted: &Trusted, part: f64) -> End {
        let outcome = catch_unwind(AssertUnwindSafe(|| self.attempt(case, trusted, part)));
        match outcome {
            Ok(Ok(end)) => end,
            Ok(Err(error)) => End::Stopped(name(&error)),
            Err(payload) => {
                let text = payload.downcast_ref::<String>().cloned();
                let text = text.or_else(|| payload.downcast_ref::<&str>().map(|s| (*s).to_owned()));
                End::Panic(text.unwrap_or_default())
            }
        }
    }

    fn attempt(&self, case: &Case, trusted: &Trusted, part: f64) -> Result<End, SimulationError> {
        let (step, tolerance) = match self.entry.tolerant {
            true => (self.step, self.tolerance * part * part),
            false => (self.step * part, self.tolerance),
        };
        let settings = self.entry.settings(step, tolerance, self.placement);
        let mut simulation = case.start(settings)?;
        for &piece in &self.pieces {
            simulation.run_until(piece)?;
        }
        simulation.run_until(trusted.instants[self.end])?;
        Ok(End::Ok {
            position: case.apart(
                trusted.size,
                &simulation.coordinates(),
                &trusted.poses[self.end],
            ),
            energy: simulation.report().energy_error,
        })
    }

    /// The error of position that runs with finer steps let expect, if this run is lost without a word.
    pub fn lost(&self, case: &Case, trusted: &Trusted, end: &End) -> Option<f64> {
        let &End::Ok { position, energy } = end else {
            return None;
        };
        let mut least = (NONE + DOUBTFUL * trusted.doubt[self.end]).max(FAR * self.floor());
        let shown = energy >= SHOWN * position.min(1.0) * trusted.energy;
        if position <= least || shown {
            return None;
        }
        for part in FINER {
            let End::Ok {
                position: error, ..
            } = self.run(case, trusted, part)
            else {
                continue;
            };
            least = least.max(FAR * self.entry.loss(part) * error);
            if position <= least {
                return None;
            }
        }
        Some(least / FAR)
    }

    /// What the tolerance allows.
    fn floor(&self) -> f64 {
        if self.entry.tolerant {
            self.tolerance
        } else {
            0.0
        }
    }
}

impl fmt::Display for Trial {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Trial {
            number,
            entry,
            step,
            tolerance,
            placement,
            end,
            pieces,
        } = self;
        write!(
            out,
            "run {number}: {}, step {step:e} s, tolerance {tolerance:.2e}, placement {placement}, instant {end}, pieces {pieces:?}",
            entry.label
        )
    }
}

/// A number between these.
fn among(random: &mut Random, [a, b]: [f64; 2]) -> f64 {
    0.5 * (a + b) + random.within(0.5 * (b - a))
}

/// The name of an error.
pub fn name(error: &SimulationError) -> String {
    let words = format!("{error:?}");
    let end = words.find(|c: char| !c.is_alphanumeric());
    words[..end.unwrap_or(words.len())].to_owned()
}
