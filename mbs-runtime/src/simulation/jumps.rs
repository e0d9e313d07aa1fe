//! Forces that jump or bend within a pair of steps: friction that turns, stops, corners of tables.
//!
//! The estimates assume that errors are proportional to a power of h. Over a jump they are not, and an error is larger than its
//! estimate by factors of thousands. Two signs show a jump:
//!
//! | sign | methods |
//! |---|---|
//! | the estimate of order 5 is more than a tenth of that of order 3 (`Estimate::is_rough`) | explicit of order 8 |
//! | the difficulty of the motion grows by more than 2¹⁰ from one pair to the next | explicit, Radau |
//!
//! Such a pair is compared with other steps. Where the first sign is there, or the difficulty by the comparison has grown by more
//! than 2²⁰, the whole difference counts as the error.

use super::Simulation;
use super::step_controller::difficulty;
use crate::System;

/// Powers of 2 by which the difficulty grows from one pair to the next only over a jump, by an estimate and by a comparison.
const GROWN: [f64; 2] = [10.0, 20.0];
/// With a smaller error ratio of the estimate a jump is harmless, or round-off.
const HARMLESS: f64 = 1e-6;
/// A difference that is a smaller part of such an estimate was not seen: with both lengths all stages lie beyond the jump.
const BLIND: f64 = 1e-4;
/// Over a jump the error may be so many times the usual one, since jumps are rare.
const RARE: f64 = 3.0;

/// What is known of a pair before it is compared.
#[derive(Debug, Clone, Copy)]
pub(super) struct Smoothness {
    /// The difficulties of the last pair that was kept, by its estimate alone and as its error was judged, where lengths follow the
    /// motion.
    pub(super) usual: [Option<f64>; 2],
    /// Whether the estimates of the pair show a jump, and are more than round-off.
    pub(super) is_rough: bool,
    /// The length of the pair, s.
    pub(super) length: f64,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The error ratio where a comparison has found this one as a part, 1/`ratio`, of the difference.
    pub(super) fn over_a_jump(&self, pair: &Smoothness, error_ratio: f64, ratio: f64) -> f64 {
        let now = self.difficulty_of(pair.length, error_ratio);
        let has_grown = pair.usual[1].is_some_and(|usual| now > usual + GROWN[1]);
        match pair.is_rough || has_grown {
            true => error_ratio * (ratio / RARE).max(1.0),
            false => error_ratio,
        }
    }

    /// The difficulty of a pair of this length with this ratio of its error to the allowed one.
    pub(super) fn difficulty_of(&self, length: f64, error_ratio: f64) -> f64 {
        difficulty(self.settings.true_order(), 0.5 * length, error_ratio)
    }
}

/// Whether an estimate with this ratio to the allowed error, and this difficulty, shows that a force may jump in the pair. Before
/// the first pair nothing is usual: then any pair that seems too long may have a jump.
pub(super) fn may_jump(pair: &Smoothness, (ratio, difficulty): (f64, f64)) -> bool {
    match pair.usual[0] {
        Some(usual) => ratio > HARMLESS && (pair.is_rough || difficulty > usual + GROWN[0]),
        None => ratio > 1.0,
    }
}

/// Whether a comparison has not seen the jump that an estimate shows: the error that it found is this factor times the estimate.
pub(super) fn is_blind(factor: Option<f64>) -> bool {
    factor.is_some_and(|factor| factor < BLIND)
}
