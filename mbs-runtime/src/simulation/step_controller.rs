//! The lengths of the next steps.
//!
//! | error by | length |
//! |---|---|
//! | comparison | the same until one comparison requires a shorter one, or several in a row allow a longer one |
//! | an embedded method | follows the motion ([`Pace`]): such that the next error ratio is 2^[`AIM_OF_STEPS`], or less after pairs that were too long, or 2^[`AIM_OF_PAIRS`] |
//!
//! A symmetric method keeps its long-time behaviour as long as its step length does not follow the motion (E. Hairer,
//! C. Lubich, G. Wanner, Geometric Numerical Integration, section VIII.1). Explicit methods have no such behaviour to keep. With
//! constant steps the slider-crank at accuracy 1e-6 uses a hundred-millionth of the allowed error in half of its motion.

use crate::StepController;

/// Comparisons in a row that allow a longer step before one is taken, at first and at most: twice as many after each
/// longer step that had to be shortened again, so that the step becomes constant for periodic motion.
pub(super) const PATIENCE: [u32; 2] = [8, 4096];
/// log₂ of the ratio of neighbouring lengths is one over this.
const NOTCHES: f64 = 4.0;
/// Notches by which a step is lengthened or shortened at once, at most.
const LEAP: f64 = 8.0;
/// The error ratio of a pair of which nothing is known but that it is too long.
pub(super) const TOO_LONG: f64 = 256.0;
/// The least growth, in notches, for which the step is lengthened, so that it is not shortened again soon.
const PROMISE: f64 = 2.0;
/// log₂ of the error ratio for which a length that follows the motion is chosen. (With smaller ones hardly a pair is too long, and
/// the error falls faster than the work grows: where each step has a length of its own the work of nine mechanisms for the same
/// error is least between 2^−6 and 2^−4.)
const AIM_OF_STEPS: f64 = -4.3;
const AIM_OF_PAIRS: f64 = -3.3;
/// Powers of 2 by which each pair that was too long lowers the aim where each step has a length of its own, and the most by which it is
/// lowered. (At accuracies of 1e-1 to 1e-2, where steps are long for the motion, up to every third pair was too long without: nine
/// mechanisms take 0.90 to 1.03 of the evaluations with it, and at finer accuracies 0.93 to 1.01 for the same error.)
const CAUTIONS: [f64; 2] = [2.0, 3.0];
/// The part of this that is left after each choice of a length: once in a pair, twice if the pair was compared.
const CAUTION_LEFT: f64 = 0.9;
/// The parts of the last change of the difficulty that are expected once more, where it grew and where it fell: from step to
/// step, and from pair to pair.
const TREND_OF_STEPS: [f64; 2] = [0.75, 0.0];
const TREND_OF_PAIRS: [f64; 2] = [0.5, 0.3];
/// By so much the difficulty of an erratic error is expected to fall from one pair to the next, in powers of 2.
const FADING: f64 = 1.0;
/// The change of the difficulty that is taken as one, at most, in powers of 2: from a larger one nothing follows.
const STEEP: f64 = 20.0;
/// Factors from one length to the next, at least and at most, where it follows the motion, and after a pair was too long.
const FACTORS: [f64; 2] = [0.3, 1.5];
/// The factor at most until a length is found.
const EAGER: f64 = 2.0;
const RETREATS: [f64; 2] = [0.2, 0.9];
/// Factors with which the length is not changed where factors of matrices are kept for it.
const SAME: [f64; 2] = [0.8, 1.25];
/// The least factor of an embedded estimate that is believed: of explicit methods (its mean over a run was between 0.12 and 1.7 in ten
/// scenes), and of Radau. Where the error is far below what is allowed, as in a start from rest, factors of a
/// millionth were found, and one of a tenth a few steps later.
const LEAST_FACTORS: [f64; 2] = [0.1, 0.02];
/// With a smaller error ratio the error of a pair is mostly round-off, and the factor of its estimate is at most the one found.
const TELLING: f64 = 1e-3;
/// The part of a usual length that is left after each pair of shorter steps.
const USUAL_LEFT: f64 = 0.8;
/// An error ratio below this is round-off.
const ROUND_OFF: f64 = 1e-12;
/// s. At rest steps grow without end; with longer ones products of them overflow.
const LONGEST: f64 = 1e18;

/// How much longer a step could be with this error, as a power of 2^¼.
pub(super) fn notches(order: u8, error_ratio: f64) -> f64 {
    (NOTCHES / f64::from(order) * -error_ratio.log2()).floor()
}

/// log₂ of the difficulty d of the motion: with order p the error ratio of steps of h is d hᵖ.
pub(super) fn difficulty(order: u8, h: f64, error_ratio: f64) -> f64 {
    // Powers of a step may overflow or vanish.
    error_ratio.max(ROUND_OFF).log2() - f64::from(order) * h.log2()
}

/// How lengths follow the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pace {
    /// Each step has its own: where the difficulty grew it is expected to go on.
    Steps,
    /// The two steps of a pair have the same, and the difficulty is expected to go on to change as it did: the energy balance of
    /// a pair may decide.
    Pairs,
    /// The same, but small changes are left out: factors of matrices are kept for a length.
    Kept,
    /// Errors have a sign, and vanish now and then: the largest of the last ones counts, less and less.
    Erratic,
}

impl Pace {
    /// log₂ of the error ratio for which a length is chosen, as a rule.
    fn usual_aim(self) -> f64 {
        match self {
            Pace::Steps => AIM_OF_STEPS,
            _ => AIM_OF_PAIRS,
        }
    }

    /// The least factor of an estimate that is believed.
    fn least_factor(self) -> f64 {
        LEAST_FACTORS[usize::from(self == Pace::Kept)]
    }

    /// The parts of a change of the difficulty that are expected once more.
    fn trend(self) -> [f64; 2] {
        match self {
            Pace::Steps => TREND_OF_STEPS,
            _ => TREND_OF_PAIRS,
        }
    }
}

impl StepController {
    /// Before the first comparison.
    pub(super) fn starting(step: f64) -> Self {
        StepController {
            step: step.min(LONGEST),
            searching: true,
            allowed: LEAP,
            patience: PATIENCE[0],
            ..StepController::default()
        }
    }

    /// For the motion that a trial has gone through: with the length of its last steps, and with the factor of its estimates if
    /// that is known (not zero).
    pub(super) fn after_trial(step: f64, estimate_factor: f64) -> Self {
        StepController {
            searching: estimate_factor == 0.0,
            estimate_factor,
            ..StepController::starting(step)
        }
    }

    /// Takes note of the factor of the estimate in a comparison with this error ratio, or of a pair that was not compared; `pace`
    /// where lengths follow the motion.
    pub(super) fn note(
        &mut self,
        estimate_factor: Option<f64>,
        error_ratio: f64,
        pace: Option<Pace>,
    ) {
        let Some(estimate_factor) = estimate_factor else {
            self.pairs_since_comparison = self.pairs_since_comparison.saturating_add(1);
            return;
        };
        self.pairs_since_comparison = 0;
        let halved = 0.5 * self.estimate_factor;
        let Some(pace) = pace else {
            self.estimate_factor = estimate_factor.max(halved);
            return;
        };
        let halved = halved.max(pace.least_factor());
        if error_ratio > TELLING {
            self.estimate_factor = estimate_factor.max(halved);
        } else if self.estimate_factor > 0.0 && !self.searching {
            // The error is at most what the comparison shows.
            self.estimate_factor = estimate_factor.max(halved).min(self.estimate_factor);
        } else if !self.searching {
            self.estimate_factor = 1.0;
        }
    }

    /// Takes note of the length of the steps of a pair that is kept.
    pub(super) fn remember(&mut self) {
        self.usual = self.step.max(USUAL_LEFT * self.usual);
    }

    /// Takes note of the difficulty by an estimate alone, if there is one.
    pub(super) fn see(&mut self, estimated_difficulty: Option<f64>) {
        self.estimated_difficulty = estimated_difficulty.or(self.estimated_difficulty);
    }

    /// The ratio of the error to the allowed one by an embedded estimate; NaN if its factor is not known for this length of
    /// steps.
    pub(super) fn predicted_error_ratio(&self, estimate: Option<f64>, allowed: f64) -> f64 {
        match estimate {
            Some(estimate) if self.estimate_factor > 0.0 && !self.searching => {
                self.estimate_factor * estimate / allowed
            }
            _ => f64::NAN,
        }
    }

    /// Shortens the step after h was too long, by this (negative) number of notches.
    pub(super) fn shorten(&mut self, h: f64, notches: f64) {
        self.step = h * (notches.clamp(-LEAP, -1.0) / NOTCHES).exp2();
        self.estimate_factor = 0.0;
        if std::mem::take(&mut self.raised) {
            self.patience = self.patience.saturating_mul(2).min(PATIENCE[1]);
        }
        self.settle();
    }

    /// Takes note of a comparison that would allow a step longer by some notches.
    pub(super) fn lengthen(&mut self, notches: f64) {
        if notches < PROMISE {
            return self.settle();
        }
        self.quiet = self.quiet.saturating_add(1);
        self.allowed = self.allowed.min(notches - 1.0);
        if self.searching || self.quiet >= self.patience {
            self.step = LONGEST.min(self.step * (self.allowed / NOTCHES).exp2());
            self.estimate_factor = 0.0;
            if std::mem::replace(&mut self.raised, !self.searching) {
                self.patience = (self.patience / 2).max(PATIENCE[0]);
            }
            self.quiet = 0;
            self.allowed = LEAP;
        }
    }

    /// The step is right, for now.
    fn settle(&mut self) {
        self.quiet = 0;
        self.allowed = LEAP;
        self.searching = false;
    }

    /// log₂ of the error ratio for which a length is chosen now.
    fn aim(&self, pace: Pace) -> f64 {
        match pace {
            Pace::Steps => pace.usual_aim() - self.caution.min(CAUTIONS[1]),
            _ => pace.usual_aim(),
        }
    }

    /// After steps of h with this error ratio: the length with which the next one comes to the aim of the pace.
    fn follow(&mut self, order: u8, h: f64, error_ratio: f64, pace: Pace) {
        let difficulty = difficulty(order, h, error_ratio);
        let order = f64::from(order);
        let change = match self.difficulty {
            Some(last) => (difficulty - last).clamp(-STEEP, STEEP),
            None => 0.0,
        };
        let trend = pace.trend()[usize::from(change < 0.0)] * change;
        let (known, expected) = match (pace, self.difficulty) {
            (Pace::Erratic, Some(last)) if !self.searching => {
                let known = difficulty.max(last - FADING);
                (known, known)
            }
            _ => (difficulty, difficulty + trend),
        };
        let wanted = (self.aim(pace) - expected) / order;
        self.caution *= CAUTION_LEFT;
        let most = if self.searching { EAGER } else { FACTORS[1] };
        let factor = (wanted.exp2() / h).clamp(FACTORS[0], most);
        self.difficulty = Some(known);
        let is_same = pace == Pace::Kept && (SAME[0]..SAME[1]).contains(&factor);
        self.step = if is_same { h } else { LONGEST.min(h * factor) };
        self.searching &= factor == EAGER;
    }

    /// After a pair of steps of h with this error ratio, which were shorter than the length in use because the run ended there: it
    /// grows where steps of that length, too, would have less than the error at which it aims.
    pub(super) fn reach_out(&mut self, order: u8, h: f64, error_ratio: f64, pace: Pace) {
        let ratio = error_ratio.max(ROUND_OFF).log2();
        let at_length = ratio + f64::from(order) * (self.step / h).log2();
        if at_length < self.aim(pace) - f64::from(order) * FACTORS[1].log2() {
            self.step = LONGEST.min(FACTORS[1] * self.step);
        }
        self.searching = false;
    }

    /// The length of the second step of a pair after a first one of h with this error ratio, and the difficulty of the first.
    pub(super) fn second(&self, order: u8, h: f64, error_ratio: f64) -> (f64, Option<f64>) {
        let mut ahead = *self;
        ahead.follow(order, h, error_ratio, Pace::Steps);
        (ahead.step, ahead.difficulty)
    }

    /// After a pair with this error ratio, of which each step has its part, or an equal one where the parts are not known; with
    /// the difficulty of the first step if that is known.
    pub(super) fn follow_pair(
        &mut self,
        order: u8,
        steps: [f64; 2],
        (error_ratio, parts): (f64, Option<[f64; 2]>),
        difficulty_of_first: Option<f64>,
        pace: Pace,
    ) {
        let length = steps[0] + steps[1];
        let Some(parts) = parts.filter(|_| pace == Pace::Steps) else {
            return self.follow(order, 0.5 * length, error_ratio, pace);
        };
        let ratio = |i: usize| error_ratio * parts[i] * length / steps[i];
        match difficulty_of_first {
            Some(_) => self.difficulty = difficulty_of_first,
            None => self.follow(order, steps[0], ratio(0), pace),
        }
        self.follow(order, steps[1], ratio(1), pace);
    }

    /// After steps of h were too long by an embedded method. If they were before, too, `again`, the factor of its estimate
    /// is no longer trusted.
    pub(super) fn retreat(
        &mut self,
        order: u8,
        h: f64,
        error_ratio: f64,
        (again, pace): (bool, Pace),
    ) {
        if pace == Pace::Steps {
            self.caution = (self.caution + CAUTIONS[0]).min(CAUTIONS[1]);
        }
        let factor = ((self.aim(pace) - error_ratio.log2()) / f64::from(order)).exp2();
        self.step = h * factor.clamp(RETREATS[0], RETREATS[1]);
        self.difficulty = match pace {
            Pace::Erratic => Some(difficulty(order, h, error_ratio)),
            _ => None,
        };
        self.searching = false;
        if again {
            self.estimate_factor = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths of steps in pairs and the error ratios of the pairs with the difficulty d(t) and order 8.
    fn run(d: impl Fn(f64) -> f64, end: f64) -> Vec<([f64; 2], f64)> {
        let mut controller = StepController::starting(1e-3);
        let (mut time, mut pairs) = (0.0, Vec::new());
        let error = |time: f64, h: f64| d(time + 0.5 * h) * h.powi(9);
        while time < end {
            let first = controller.step;
            let (second, known) = match controller.searching {
                true => (first, None),
                false => controller.second(8, first, error(time, first) / first),
            };
            let (steps, length) = ([first, second], first + second);
            let errors = [error(time, first), error(time + first, second)];
            let sum = errors[0] + errors[1];
            let error_ratio = sum / length;
            match error_ratio <= 1.0 {
                true => {
                    let parts = Some(errors.map(|error| error / sum));
                    controller.follow_pair(8, steps, (error_ratio, parts), known, Pace::Steps);
                    time += length;
                }
                false => controller.retreat(8, first, error_ratio, (false, Pace::Steps)),
            }
            pairs.push((steps, error_ratio));
        }
        pairs
    }

    #[test]
    fn a_constant_difficulty_has_a_constant_length() {
        let pairs = run(|_| 1e8, 10.0);
        let wanted = (0.125 * (AIM_OF_STEPS - 1e8f64.log2())).exp2();
        assert!(
            pairs
                .iter()
                .skip(10)
                .all(|(steps, _)| steps.iter().all(|h| (h / wanted - 1.0).abs() < 1e-9))
        );
    }

    #[test]
    fn lengths_follow_a_difficulty_of_eight_decades() {
        let difficulty = |time: f64| 10f64.powf(8.0 + 4.0 * time.sin());
        let pairs = run(difficulty, 20.0);
        let kept = pairs
            .iter()
            .filter(|(_, error_ratio)| *error_ratio <= 1.0)
            .count();
        // The least constant length needs 20 / (2 · 0.0218) = 459 pairs.
        assert!(kept < 230, "{kept}");
        assert!(pairs.len() - kept <= 2, "{} of {kept}", pairs.len());
    }

    #[test]
    fn the_second_step_of_a_pair_is_shorter_where_the_first_one_was_hard() {
        let mut controller = StepController::starting(0.1);
        controller.searching = false;
        let second = |error_ratio| controller.second(8, 0.1, error_ratio).0;
        let aim = AIM_OF_STEPS.exp2();
        assert!((second(aim) / 0.1 - 1.0).abs() < 1e-12);
        assert!((second(16.0 * aim) / 0.1 - 0.5f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_pair_that_was_too_long_lowers_the_aim_for_a_while() {
        let mut controller = StepController::starting(0.1);
        let aims = |controller: &StepController| controller.aim(Pace::Steps) - AIM_OF_STEPS;
        controller.retreat(8, 0.1, 4.0, (false, Pace::Steps));
        assert_eq!(aims(&controller), -2.0);
        controller.retreat(8, 0.1, 4.0, (true, Pace::Steps));
        assert_eq!(aims(&controller), -3.0);
        assert_eq!(controller.aim(Pace::Kept), AIM_OF_PAIRS);
        for _ in 0..20 {
            controller.follow(8, 0.1, 0.05, Pace::Steps);
        }
        assert!((-0.4..-0.3).contains(&aims(&controller)));
        let mut other = StepController::starting(0.1);
        other.retreat(8, 0.1, 4.0, (false, Pace::Pairs));
        assert_eq!(other.caution, 0.0);
    }

    #[test]
    fn a_pair_without_parts_has_one_length() {
        for (parts, pace) in [
            (None, Pace::Steps),
            (Some([0.2, 0.8]), Pace::Pairs),
            (Some([0.2, 0.8]), Pace::Erratic),
        ] {
            let mut controller = StepController::starting(0.1);
            controller.searching = false;
            let errors = (pace.usual_aim().exp2(), parts);
            controller.follow_pair(8, [0.12, 0.08], errors, None, pace);
            assert!((controller.step / 0.1 - 1.0).abs() < 1e-12, "{pace:?}");
        }
    }

    /// A comparison that is mostly round-off bounds the factor, and does not raise it; while the length is searched it says nothing.
    #[test]
    fn round_off_halves_the_factor_of_the_estimate_at_most() {
        let noted = |found: f64, searching: bool| {
            let mut controller = StepController::after_trial(0.1, 1.0);
            controller.searching = searching;
            controller.note(Some(found), 1e-4, Some(Pace::Steps));
            controller.estimate_factor
        };
        assert_eq!(noted(0.01, false), 0.5);
        assert_eq!(noted(0.8, false), 0.8);
        assert_eq!(noted(1e6, false), 1.0);
        assert_eq!(noted(0.01, true), 1.0);
    }
}
