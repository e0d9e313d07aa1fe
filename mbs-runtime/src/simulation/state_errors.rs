//! The errors of states in pairs of steps.
//!
//! They are relative to the size of the state, and allowed as the motion goes on:
//!
//! ```text
//! e ≤ share · tolerance · max(way of the mechanism, largest relative change of a state)
//! ```
//!
//! The rate of a state may jump or bend where no force does. Over a jump of its rate by a, a state has an error of about a h: as a
//! part of the way this does not fall with h. So there the pair may have the error of one with the usual length, of the size of the
//! state at most.
//!
//! | | the error by the difference d from the other steps |
//! |---|---|
//! | the rate is smooth | d / (2ᵖ − 1), or the same with another factor |
//! | it jumps | d / 3, since jumps are rare |
//!
//! Which of them counts is asked by a comparison with two unequal steps: from them a smooth motion has a difference that is far
//! smaller, by the factor of the orders. It is asked where the error is allowed over a jump alone, and where it is allowed in smooth
//! motion alone and the difficulty of states has grown fourfold. Where both allow it, growth by more than 2¹⁰ is a jump without asking.
//!
//! Stages of Radau do not see a jump before the first of them. Its embedded formula does, since it has the rate at the beginning.

use super::Simulation;
use super::comparison::SHARE;
use super::jumps::RARE;
use super::step_controller::{PATIENCE, TOO_LONG, difficulty};
use crate::scalar_state::relative;
use crate::yardstick::ROUND_OFF;
use crate::{ScalarState, SimulationError, StepController, System};

/// The steps with which a pair is compared once more, as parts of its length.
const UNEQUAL: [f64; 2] = [0.3, 0.7];
/// In smooth motion the difficulty of states seldom grows from one pair to the next by more than this power of 2.
const GROWTH: f64 = 2.0;
/// The largest of the last difficulties falls by this power of 2 with each pair.
const FADING: f64 = 2.0;
/// Growth by more than this is a jump.
const CERTAIN: f64 = 10.0;
/// Where no comparison sees an error, an estimate of so many times the allowed one shows a jump before the first stage.
const UNSEEN: f64 = 64.0;

/// Relative differences up to this multiple of the round-off of a number do not fall with the length: they ask for no other length.
/// (Extrapolated steps of order 8 had 20.)
const NOISY: f64 = 64.0;
/// The shortest steps that are tried are those over a jump where the usual ones are so many times as long.
const SUDDEN: f64 = 10.0;
/// There a state may have an error of so many tolerances.
const LAST: f64 = 10.0;

/// What is allowed, and what is known of the pair.
pub(super) struct Pair {
    /// Its steps, s.
    pub(super) steps: [f64; 2],
    /// The part of a way that is allowed, the way of the mechanism, and round-off.
    pub(super) share: f64,
    pub(super) way: f64,
    pub(super) noise: f64,
    /// [`Estimate::of_states`](crate::estimate::Estimate::of_states).
    pub(super) estimates: [f64; 2],
    /// Whether it has the shortest steps that are tried.
    pub(super) is_shortest: bool,
}

/// What a comparison shows of states.
#[derive(Debug, Clone, Copy)]
pub(super) enum Seen {
    /// A rate jumps.
    Jump,
    /// Their difficulty.
    Difficulty(f64),
    /// Round-off, or what may be a jump: a bound of it.
    AtMost(f64),
}

/// The errors of states in a pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct OfStates {
    /// The ratio of the error to the allowed one.
    pub(super) error_ratio: f64,
    /// The velocity that has it.
    pub(super) velocity: usize,
    pub(super) seen: Seen,
}

/// The largest differences of states between the pair and other steps.
#[derive(Debug, Clone, Copy)]
struct Apart {
    /// As multiples of what is allowed of smooth states, and over a jump.
    smooth: f64,
    jump: f64,
    velocity: usize,
    /// What is allowed, relative to sizes.
    allowed: [f64; 2],
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The errors of states in the pair. Now the simulation is at the end of the other steps; in smooth motion the error of the pair is
    /// the difference divided by `ratio`. `force_jumps`: whether the motion shows a jump. Leaves the simulation in any state.
    pub(super) fn errors_of_states(
        &mut self,
        pair: &Pair,
        (ratio, force_jumps): (f64, bool),
        controller: &StepController,
    ) -> Result<Option<OfStates>, SimulationError> {
        let Some(apart) = self.states_apart(pair, controller) else {
            return Ok(None);
        };
        let of = |error_ratio, seen| {
            let velocity = apart.velocity;
            Ok(Some(OfStates {
                error_ratio,
                velocity,
                seen,
            }))
        };
        let (smooth, jump) = (apart.smooth / ratio, apart.jump / RARE);
        let order = self.settings.true_order();
        let length: f64 = pair.steps.into_iter().sum();
        if pair.is_shortest && 2.0 * controller.usual > SUDDEN * length {
            // The jump is within this time, in which no state moves far. (Where all steps are as short, motion is too fast for them.)
            let tolerance = pair.share / SHARE;
            let least = apart.smooth * apart.allowed[0] / (LAST * tolerance);
            return of(smooth.min(least), Seen::Jump);
        }
        let [plain, raised] = pair.estimates;
        if smooth <= 1.0 && raised > UNSEEN * apart.allowed[0] {
            let unseen = plain / (RARE * apart.allowed[1]);
            return of(over(jump.max(unseen), order), Seen::Jump);
        }
        let now = difficulty(order, 0.5 * length, smooth);
        if apart.smooth * apart.allowed[0] <= NOISY * ROUND_OFF {
            return of(0.0, Seen::AtMost(now));
        }
        let is_unlike = (controller.difficulty).is_none_or(|last| now > last + GROWTH);
        let is_asked = match (smooth <= 1.0, jump <= 1.0) {
            (true, false) => is_unlike,
            (false, true) => true,
            _ => false,
        };
        let jumps =
            force_jumps || is_asked && self.rates_jump(pair, (ratio, apart.smooth), controller)?;
        let is_small = smooth <= 1.0 && jump <= 1.0;
        match (jumps && !is_small, is_small && is_unlike) {
            (true, _) if smooth <= 1.0 => of(jump, Seen::Jump),
            (true, _) => of(over(jump, order), Seen::Jump),
            // It was not asked whether a rate jumps.
            (_, true) => match controller.difficulty {
                Some(last) if now > last + CERTAIN => of(smooth, Seen::Jump),
                _ => of(smooth, Seen::AtMost(now)),
            },
            _ => of(smooth, Seen::Difficulty(now)),
        }
    }

    /// Whether the difference from unequal steps is not smaller than that from the other ones, as it is where rates are smooth.
    fn rates_jump(
        &mut self,
        pair: &Pair,
        (ratio, apart): (f64, f64),
        controller: &StepController,
    ) -> Result<bool, SimulationError> {
        let length: f64 = pair.steps.into_iter().sum();
        let order = i32::from(self.settings.true_order());
        let of = |steps| error_of(steps, length, order);
        let steps = UNEQUAL.map(|part| part * length);
        let unequal = of(steps) / of(pair.steps) - 1.0;
        if unequal.abs() >= ratio || self.others(steps)?.is_none() {
            return Ok(false);
        }
        let other = self.states_apart(pair, controller);
        Ok(other.is_some_and(|other| other.smooth > apart * (unequal.abs() / ratio).cbrt()))
    }

    /// The largest distance of a state after the other steps from that after the pair.
    fn states_apart(&self, pair: &Pair, controller: &StepController) -> Option<Apart> {
        let [begin, end, other] =
            [&*self.pair_start, &*self.pair_end, self.state()].map(|state| &state.velocities);
        let of = |state: &ScalarState, from, to| {
            let change = to - from;
            relative(core::slice::from_ref(state), &change, end)
        };
        let states = self.system().states();
        let largest = |from, to| {
            let changes = states.iter().map(|state| of(state, from, to));
            changes.fold(pair.way, f64::max)
        };
        let way = largest(begin, end);
        let length: f64 = pair.steps.into_iter().sum();
        let longer = (2.0 * controller.usual / length).max(1.0);
        let usual = (longer * way.max(largest(begin, other))).min(1.0).max(way);
        let allowed = [way, usual].map(|way| (pair.share * way).max(pair.noise));
        let apart = states
            .iter()
            .map(|state| (of(state, end, other), state.velocity));
        let (apart, velocity) = apart.max_by(|(one, _), (other, _)| one.total_cmp(other))?;
        Some(Apart {
            smooth: apart / allowed[0],
            jump: apart / allowed[1],
            velocity,
            allowed,
        })
    }
}

/// The error of steps within this length, as if the motion were as difficult in all of them, up to a factor.
pub(super) fn error_of(steps: [f64; 2], length: f64, order: i32) -> f64 {
    let power = |h: f64| (h / length).powi(order + 1);
    steps.into_iter().map(power).sum()
}

/// An error ratio that falls with the length itself, as one of this order: the length is changed accordingly.
fn over(error_ratio: f64, order: u8) -> f64 {
    match error_ratio > 1.0 {
        true => error_ratio.powi(i32::from(order)).min(TOO_LONG.powi(2)),
        false => error_ratio,
    }
}

impl StepController {
    /// Takes note of the difficulty of states in a pair that was kept. Behind a jump the length is looked for anew: it may be a
    /// billion times that of the steps which led up to it.
    pub(super) fn see_states(&mut self, seen: Option<Seen>) {
        let last = self.difficulty;
        let faded = |now: f64| last.map_or(now, |last| now.max(last - FADING));
        match seen {
            Some(Seen::Difficulty(now)) => self.difficulty = Some(faded(now)),
            Some(Seen::AtMost(now)) => self.difficulty = last.map(|last| last.min(faded(now))),
            Some(Seen::Jump) => {
                (self.searching, self.raised, self.patience) = (true, false, PATIENCE[0]);
            }
            None => {}
        }
    }
}
