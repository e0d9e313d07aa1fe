//! Jumps of forces within a pair of steps: friction that turns, stops, corners of tables.
//!
//! The estimates assume that errors are proportional to a power of h. Over a jump they are not, and an error is larger than its
//! estimate by factors of thousands. A pair that may have a jump is compared with other steps. Where it has one, the whole
//! difference counts as the error:
//!
//! | methods | the pair may have a jump | it has one |
//! |---|---|---|
//! | explicit of order 8 | the estimate of order 5 is more than a tenth of that of order 3 ([`Estimate::is_rough`]) | the same |
//! | explicit of order 8 | the difficulty by the estimate is more than 2¹⁰ times the previous one | the difficulty by the comparison is more than 2²⁰ times the previous one |
//! | Radau | the difficulty by the estimate is more than √2 times the previous one, or less than 1/√2 of it (it falls where a stop is left) | the difficulty by the comparison is more than 2²⁰ times the previous one, or the error is more than 8 times the estimate with its previous factor |
//! | two-level, orders 4 to 8 | the difficulty by the estimate is more than √2 times the previous one | it is more than 2³ times that, or the error is more than 8 times the estimate with its previous factor |
//!
//! The previous values are those of the last pair that was kept and had the chosen length. Methods without an estimate compare
//! every pair. So do all methods for mechanisms with states, whose errors no estimate shows: lengths are then constant, and a pair has
//! a jump where the estimate is rough, or by the rule of two-level steps. (Rates of states that jump: `state_errors.rs`.) Mechanisms with
//! [`Structure::smooth`](crate::Structure::smooth) have no jumps.

use super::Simulation;
use super::step_controller::difficulty;
use crate::estimate::Estimate;
use crate::{Method, StepController, System};

/// Where lengths follow the motion, the difficulty grows from one pair to the next by more than this power of 2 only over a jump: by
/// the estimate, …
const GROWTH_BY_ESTIMATE: f64 = 10.0;
/// … and by the comparison.
const GROWTH_BY_COMPARISON: f64 = 20.0;
/// The same by the estimate where lengths are constant: with a larger growth there may be a jump, …
const SUDDEN: f64 = 0.5;
/// … and with this one there is. (Of the values tried, these gave the least errors of random motions, for a tenth more stages at order 4
/// and four tenths at order 8. A turn of friction in which the estimate of order 4 grew by 2^0.8 alone was not seen with 3 in place of
/// 0.5.)
const CERTAIN: f64 = 3.0;
/// Where lengths are constant, the multiple of the estimate that the error is has grown by more than this factor only over a jump.
pub(super) const UNUSUAL: f64 = 8.0;
/// With a smaller error ratio of the estimate a jump is harmless, or round-off.
const HARMLESS: f64 = 1e-6;
/// A difference that is a smaller part of such an estimate was not seen: with both lengths all stages lie beyond the jump.
const BLIND: f64 = 1e-4;
/// Over a jump the error may be so many times the usual one, since jumps are rare.
pub(super) const RARE: f64 = 3.0;

/// What the pairs before were like.
#[derive(Debug, Clone, Copy)]
pub(super) struct Previous {
    /// The difficulty by the estimate alone.
    estimated: Option<f64>,
    /// The difficulty as the error was judged, where lengths follow the motion.
    judged: Option<f64>,
    /// The factor of the estimate; zero: not known.
    factor: f64,
}

impl Previous {
    pub(super) fn of(controller: &StepController) -> Self {
        Previous {
            estimated: controller.estimated_difficulty,
            judged: controller.difficulty,
            factor: controller.estimate_factor,
        }
    }
}

/// What shows a jump in a pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Signs {
    previous: Previous,
    /// The ratio of the estimate to the allowed error, and the difficulty by it.
    estimated: Option<[f64; 2]>,
    /// Whether the estimate is more than round-off.
    is_clear: bool,
    /// The difficulty of an estimate as large as round-off; below it growth cannot be told.
    of_round_off: f64,
    /// [`Estimate::is_rough`].
    is_rough: bool,
    /// Whether lengths follow the motion.
    follows: bool,
    /// Whether the estimate is one of lower order, raised to that of the step: this hides what is not smooth.
    is_raised: bool,
    is_two_level: bool,
    order: u8,
    /// The mean length of the steps, s.
    step: f64,
}

impl Signs {
    /// The difficulty by the estimate. That of round-off is a bound, and high where steps are short.
    pub(super) fn difficulty(&self) -> Option<f64> {
        let [_, now] = self.estimated?;
        let most = self.previous.estimated.filter(|_| !self.is_clear);
        Some(most.map_or(now, |most| now.min(most)))
    }

    /// Powers of 2 by which the difficulty has grown by the estimate, where the previous one is known.
    fn growth(&self) -> Option<f64> {
        let previous = self.previous.estimated?;
        self.difficulty().map(|now| now - previous)
    }

    /// Whether a force may jump in the pair, before it is compared. Where lengths follow the motion and nothing is known of
    /// pairs before, any pair that seems too long may have a jump.
    pub(super) fn may_jump(&self) -> bool {
        let Some([ratio, _]) = self.estimated.filter(|_| self.is_clear) else {
            return false;
        };
        let has_changed = match (self.follows, self.growth()) {
            (true, None) => ratio > 1.0,
            (true, Some(growth)) if !self.is_raised => growth > GROWTH_BY_ESTIMATE,
            // The difficulty falls where a stop is left.
            (true, Some(growth)) => growth.abs() > SUDDEN,
            (false, growth) => growth.is_some_and(|growth| growth > SUDDEN),
        };
        ratio > HARMLESS && (self.is_rough || has_changed)
    }

    /// Whether a force jumps in the pair, if the comparison has found this error ratio and this factor of the estimate.
    pub(super) fn is_jump(&self, error_ratio: f64, factor: Option<f64>) -> bool {
        let usual = UNUSUAL * self.previous.factor;
        let is_unusual = usual > 0.0 && factor.is_some_and(|factor| factor > usual);
        if self.follows {
            let now = difficulty(self.order, self.step, error_ratio);
            let previous = self.previous.judged;
            let has_grown = previous.is_some_and(|judged| now > judged + GROWTH_BY_COMPARISON);
            let is_unusual = self.is_raised && is_unusual;
            return has_grown || (self.is_clear && (self.is_rough || is_unusual));
        }
        let has_grown = self.growth().is_some_and(|growth| growth > CERTAIN);
        self.is_clear && (self.is_rough || is_unusual || has_grown)
    }

    /// Whether a pair that may have a jump is unlike smooth motion: by the roughness of the estimate, or by its growth out of
    /// round-off. (Below it an estimate grows slowly from one pair of short steps to the next, while the previous difficulty stays
    /// the least one so far.)
    pub(super) fn is_sudden(&self) -> bool {
        let hidden = self
            .previous
            .estimated
            .map_or(0.0, |previous| self.of_round_off - previous);
        let growth = self.growth().map(|growth| growth - hidden.max(0.0));
        !self.is_raised || growth.is_none_or(|growth| growth > GROWTH_BY_ESTIMATE)
    }

    /// Whether a comparison has not seen the jump that an estimate shows: the error that it found is this factor times the estimate.
    /// (The measure of two-level steps is no estimate of their error.)
    pub(super) fn is_blind(&self, factor: Option<f64>) -> bool {
        !self.is_two_level && self.is_sudden() && factor.is_some_and(|factor| factor < BLIND)
    }
}

/// An error ratio over a jump, if a smooth motion had the first one as the part 1/`ratio` of the difference.
pub(super) fn over_a_jump(error_ratio: f64, ratio: f64) -> f64 {
    error_ratio * (ratio / RARE).max(1.0)
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// What shows a jump in a pair of this length, of which this error is allowed; `None` in a mechanism that has no jumps.
    pub(super) fn signs(
        &self,
        previous: Previous,
        estimate: Option<Estimate>,
        (length, allowed, noise): (f64, f64, f64),
    ) -> Option<Signs> {
        if const { S::STRUCTURE.smooth } {
            return None;
        }
        let (order, step) = (self.settings.true_order(), 0.5 * length);
        let difficulty = |ratio: f64| difficulty(self.order_of_estimate(), step, ratio);
        let estimated = estimate.map(|pair| {
            let ratio = pair.error / allowed;
            [ratio, difficulty(ratio)]
        });
        Some(Signs {
            previous,
            estimated,
            is_clear: estimate.is_some_and(|pair| pair.error > noise),
            of_round_off: difficulty(noise / allowed),
            is_rough: estimate.is_some_and(|pair| pair.is_rough),
            follows: self.follows(),
            is_raised: self.settings.method == Method::Radau,
            is_two_level: self.settings.method == Method::TwoLevel,
            order,
            step,
        })
    }

    /// The power of h of an estimate divided by the length of the pair. For two-level steps of order 8, and for all of them where
    /// forces depend on velocities, it is less than that of the error (`alf3f/embedded.rs`, `alf3f/extrapolation.rs`).
    fn order_of_estimate(&self) -> u8 {
        let order = self.settings.true_order();
        let is_two_level = self.settings.method == Method::TwoLevel;
        let is_lower = is_two_level && (order == 8 || S::STRUCTURE.velocity_forces);
        order - u8::from(is_lower)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pair whose estimate is this part of the allowed error and makes the motion more difficult than before by this power of 2.
    fn signs(follows: bool, ratio: f64, growth: Option<f64>) -> Signs {
        Signs {
            previous: Previous {
                estimated: growth.map(|growth| 7.0 - growth),
                judged: Some(difficulty(8, 0.1, 1e-3)),
                factor: 0.1,
            },
            estimated: Some([ratio, 7.0]),
            is_clear: true,
            of_round_off: -30.0,
            is_rough: false,
            follows,
            is_raised: false,
            is_two_level: false,
            order: 8,
            step: 0.1,
        }
    }

    #[test]
    fn what_may_be_a_jump_is_compared() {
        for (follows, ratio, growth, expected) in [
            (true, 0.1, Some(9.0), false),
            (true, 0.1, Some(11.0), true),
            (true, 1e-7, Some(11.0), false),
            (true, 0.9, None, false),
            (true, 1.1, None, true),
            (false, 0.1, Some(0.4), false),
            (false, 0.1, Some(0.6), true),
            (false, 1e-7, Some(0.6), false),
            (false, 1.1, None, false),
        ] {
            let may_jump = signs(follows, ratio, growth).may_jump();
            assert_eq!(may_jump, expected, "{follows} {ratio} {growth:?}");
        }
        let rough = Signs {
            is_rough: true,
            ..signs(true, 0.1, None)
        };
        assert!(rough.may_jump());
        let round_off = Signs {
            is_clear: false,
            ..rough
        };
        assert!(!round_off.may_jump());
    }

    /// Its estimate is raised from a lower order: only a comparison shows what is not smooth.
    #[test]
    fn any_change_of_the_difficulty_of_radau_is_looked_at() {
        let radau = |growth| Signs {
            is_raised: true,
            ..signs(true, 0.1, Some(growth))
        };
        for (growth, expected) in [(0.4, false), (0.6, true), (-0.4, false), (-0.6, true)] {
            assert_eq!(radau(growth).may_jump(), expected, "{growth}");
        }
        assert!(radau(-0.6).is_jump(1e-3, Some(0.9)));
        assert!(!radau(-0.6).is_jump(1e-3, Some(0.7)));
        assert!(!radau(0.6).is_sudden() && radau(11.0).is_sudden());
        assert!(signs(true, 0.1, Some(0.6)).is_sudden());
    }

    /// Where the estimate was round-off before, it may have grown in many pairs.
    #[test]
    fn a_growth_out_of_round_off_is_no_jump() {
        let radau = |of_round_off| Signs {
            is_raised: true,
            of_round_off,
            ..signs(true, 0.1, Some(14.0))
        };
        // From −7 to 7.
        for (of_round_off, expected) in [(-8.0, true), (-4.0, true), (-2.0, false), (6.9, false)] {
            assert_eq!(radau(of_round_off).is_sudden(), expected, "{of_round_off}");
        }
    }

    #[test]
    fn the_difficulty_of_round_off_is_a_bound() {
        let round_off = |growth| Signs {
            is_clear: false,
            ..signs(true, 0.1, Some(growth))
        };
        assert_eq!(round_off(2.0).difficulty(), Some(5.0));
        assert_eq!(round_off(-2.0).difficulty(), Some(7.0));
        assert_eq!(signs(true, 0.1, Some(2.0)).difficulty(), Some(7.0));
    }

    #[test]
    fn growth_and_an_unusual_factor_show_a_jump() {
        let two_level = |growth, factor| signs(false, 0.1, growth).is_jump(1.0, Some(factor));
        assert!(!two_level(Some(2.9), 0.7));
        assert!(two_level(Some(3.1), 0.7));
        assert!(two_level(None, 0.9));
        let explicit = |error_ratio| signs(true, 0.1, Some(11.0)).is_jump(error_ratio, Some(1.0));
        assert!(!explicit(1e-3 * 2f64.powi(19)));
        assert!(explicit(1e-3 * 2f64.powi(21)));
    }
}
