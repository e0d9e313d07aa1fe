//! Jumps of forces within a pair of steps: friction that turns, stops, corners of tables.
//!
//! The estimates assume that errors are proportional to a power of h. Over a jump they are not, and an error is larger than its
//! estimate by factors of thousands. A pair that may have a jump is compared with other steps, and where these show one, too,
//! their whole difference counts as the error:
//!
//! | methods | the pair may have a jump | it has one |
//! |---|---|---|
//! | explicit of order 8 | the estimate of order 5 is more than a tenth of that of order 3 (`Estimate::is_rough`) | the same |
//! | explicit, Radau | the difficulty by the estimate is more than 2¹⁰ times that of the last pair | by the comparison it is more than 2²⁰ times that |
//! | two-level | it is more than √2 times that | it is more than 2³ times that, or the error is more than 8 times what the usual factor of the estimate makes of it |
//!
//! Mechanisms of sums, products, sines and cosines alone ([`Structure::smooth`](crate::Structure::smooth)) have no jumps.

use super::Simulation;
use super::step_controller::difficulty;
use crate::System;

/// Powers of 2 by which the difficulty grows from one pair to the next only over a jump where lengths follow the motion, by an estimate
/// and by a comparison.
const GROWN: [f64; 2] = [10.0, 20.0];
/// The same by the estimate where lengths are constant: over what may be a jump, and over what is one.
const SUDDEN: [f64; 2] = [0.5, 3.0];
/// How many times its usual multiple of the estimate the error is at least over a jump, where lengths are constant.
const UNUSUAL: f64 = 8.0;
/// With a smaller error ratio of the estimate a jump is harmless, or round-off.
const HARMLESS: f64 = 1e-6;
/// A difference that is a smaller part of such an estimate was not seen: with both lengths all stages lie beyond the jump.
const BLIND: f64 = 1e-4;
/// Over a jump the error may be so many times the usual one, since jumps are rare.
const RARE: f64 = 3.0;

/// What is known of a pair before it is compared.
#[derive(Debug, Clone, Copy)]
pub(super) struct Smoothness {
    /// The difficulties of the last pair that was kept, by its estimate alone and, where lengths follow the motion, as its error was
    /// judged.
    pub(super) usual: [Option<f64>; 2],
    /// The factor of the estimates before; zero: not known.
    pub(super) usual_factor: f64,
    /// The ratio of the estimate to the allowed error, and the difficulty by it.
    pub(super) estimated: Option<[f64; 2]>,
    /// Whether the estimates of the steps show a jump ([`crate::estimate::Estimate`]).
    pub(super) is_rough: bool,
    /// Whether the estimate is more than round-off.
    pub(super) is_clear: bool,
    /// The length of the pair, s.
    pub(super) length: f64,
}

impl Smoothness {
    /// Powers of 2 by which the difficulty has grown by the estimate, where a pair before is known.
    fn grown(&self) -> Option<f64> {
        let [_, difficulty] = self.estimated?;
        self.usual[0].map(|usual| difficulty - usual)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Whether a force may jump in the pair. Before the first pair nothing is usual: then any pair that seems too long may have a jump.
    pub(super) fn may_jump(&self, pair: &Smoothness) -> bool {
        let Some([ratio, _]) = pair.estimated.filter(|_| pair.is_clear) else {
            return false;
        };
        if const { S::STRUCTURE.smooth } {
            return false;
        }
        match (self.follows(), pair.grown()) {
            (true, None) => ratio > 1.0,
            (false, None) => false,
            (true, Some(grown)) => ratio > HARMLESS && (pair.is_rough || grown > GROWN[0]),
            (false, Some(grown)) => ratio > HARMLESS && grown > SUDDEN[0],
        }
    }

    /// The error ratio where a comparison has found this one as a part, 1/`ratio`, of the difference; `factor` is that of the
    /// estimate.
    pub(super) fn over_a_jump(
        &self,
        pair: &Smoothness,
        (error_ratio, ratio): (f64, f64),
        factor: Option<f64>,
    ) -> f64 {
        if const { S::STRUCTURE.smooth } {
            return error_ratio;
        }
        let is_jump = match self.follows() {
            true => {
                let now = self.difficulty_of(pair.length, error_ratio);
                let has_grown = pair.usual[1].is_some_and(|usual| now > usual + GROWN[1]);
                pair.is_clear && pair.is_rough || has_grown
            }
            false => {
                let usual = UNUSUAL * pair.usual_factor;
                let is_unusual = usual > 0.0 && factor.is_some_and(|factor| factor > usual);
                pair.is_clear && (is_unusual || pair.grown().is_some_and(|grown| grown > SUDDEN[1]))
            }
        };
        match is_jump {
            true => error_ratio * (ratio / RARE).max(1.0),
            false => error_ratio,
        }
    }

    /// Whether a comparison has not seen the jump that an estimate shows: the error that it found is this factor times the estimate.
    pub(super) fn is_blind(&self, factor: Option<f64>) -> bool {
        self.follows() && factor.is_some_and(|factor| factor < BLIND)
    }

    /// The difficulty of a pair of this length with this ratio of its error to the allowed one.
    pub(super) fn difficulty_of(&self, length: f64, error_ratio: f64) -> f64 {
        difficulty(self.settings.true_order(), 0.5 * length, error_ratio)
    }
}
