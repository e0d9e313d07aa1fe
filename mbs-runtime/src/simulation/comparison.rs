//! What a pair of steps is compared with, and the error that this shows ([`tolerance`](super::tolerance)).

use super::Simulation;
use super::jumps::{Previous, Signs, UNUSUAL, over_a_jump};
use super::known_poses::SAME;
use super::pose::{FAR, Passage};
use super::state_errors::{Pair, Seen, error_of};
use super::step_controller::{Pace, TOO_LONG};
use super::tolerance::{CLOCK, SHORTEST};
use crate::linear::vector;
use crate::singular::RankMargin;
use crate::yardstick::ROUND_OFF;
use crate::{Energy, ErrorOf, SimulationError, StepController, System};
use nalgebra::SVector;

/// The part of the tolerance that a pair may use: errors of tens of radians of motion add up, and grow with it.
pub(super) const SHARE: f64 = 0.02;
/// A difference above this fraction of the motion is too large for an error estimate by the order.
const UNLIKE: f64 = 0.3;
/// The steps with which a pair is compared: one of its whole length, otherwise two unequal ones, divided at these
/// fractions.
const PARTITIONS: [f64; 4] = [1.0, 0.3, 0.7, 0.2];
/// As many of them where an embedded method estimates the error: the others have hardly ever led to a pair that was kept.
const ESTIMATED: usize = 2;
/// Other steps whose error is not larger than that of the pair by at least this fraction give no estimate.
const TELLING: f64 = 0.2;
/// Where steps have constant lengths, an error ratio below this counts as this: it is mostly round-off.
const TOO_SMALL: f64 = 1e-3;
/// Round-off of the position rows grows by 1/σ beside a singular pose, up to the reciprocal of this.
const WEAKEST: f64 = 1e-5;
/// Corrections of explicit steps square what is left of the rows, and most end far below their tolerance: this part of it is
/// expected, where σ is above the second number. Closer to a pose velocities have other errors.
const PROJECTED: [f64; 2] = [0.1, 1e-3];
/// Pairs without a comparison in a row, at most: where each step has a length of its own, where a pair has one, and where lengths
/// are constant. With more of them the factor of the estimate is that of another part of the motion.
pub(super) const UNCOMPARED: [u32; 3] = [63, 15, 7];
/// The error ratio of an estimate, times the last factor, up to which a pair is kept without a comparison, where each step has a
/// length of its own and otherwise, …
pub(super) const CLEARLY: [f64; 2] = [0.75, 0.5];
/// … and from which on it is not kept, where lengths follow the motion.
const TOO_MUCH: f64 = 1.0;
/// A second step that would be longer than this part of what is left takes all of it.
const NEARLY: f64 = 0.8;
/// The least step, as a part of the first one, with which a mechanism can be at rest …
const PACED: f64 = 1e-5;
/// … but for as many pairs: a force that jumps once sets it in motion, and all of the way of a pair is then due to the jump.
const STILL_PAIRS: u32 = 16;
/// Steps shorter than this multiple of the shortest that the clock counts are next to it.
const NEAR_CLOCK: f64 = 16.0;

/// What a comparison found.
pub(super) struct Found {
    /// The ratio of the error to the allowed error; NaN if singular poses prevent the estimate.
    pub(super) error_ratio: f64,
    /// What has this error ratio.
    pub(super) of: ErrorOf,
    /// Sizes and radians a second.
    pub(super) speed: f64,
    /// Whether both steps have the lengths that were chosen for them.
    pub(super) as_chosen: bool,
    /// The factor of the embedded estimate, if the pair was compared.
    pub(super) estimate_factor: Option<f64>,
    /// The same as it was measured, without the least value of constant steps.
    pub(super) measured_factor: Option<f64>,
    /// Whether the stages give an estimate of the error of this pair.
    pub(super) is_embedded: bool,
    /// The difficulty of the first step, if the second one was chosen for it and the pair was not compared.
    pub(super) difficulty_of_first: Option<f64>,
    /// The difficulty of the pair by its estimate alone.
    pub(super) estimated_difficulty: Option<f64>,
    /// The part of the estimate that each of the steps has.
    pub(super) parts: Option<[f64; 2]>,
    /// Whether the comparison shows round-off alone: its ratio to the estimate tells nothing.
    pub(super) is_round_off: bool,
    /// Whether a force jumps or bends in the pair.
    pub(super) is_jump: bool,
    /// Whether it differs from the other steps by about its way: it begins at rest, or is far too long.
    pub(super) is_apart: bool,
    /// Whether its steps are so long that a mechanism can be at rest with them.
    pub(super) is_paced: bool,
    /// What the comparison shows of states.
    pub(super) of_states: Option<Seen>,
    /// The error of the energy balance after the first step, J.
    pub(super) imbalance: f64,
    /// The error of the work of forces without potential, J, in driven mechanisms.
    pub(super) work_error: f64,
    pub(super) passage: Passage,
}

impl Found {
    /// Before the error of these steps is known; the balance is that after the first one.
    pub(super) fn before(steps: [f64; 2], margins: [RankMargin; 3], balance: &Energy) -> Self {
        Found {
            error_ratio: f64::NAN,
            of: ErrorOf::Motion,
            speed: 0.0,
            as_chosen: false,
            estimate_factor: None,
            measured_factor: None,
            is_embedded: false,
            difficulty_of_first: None,
            estimated_difficulty: None,
            parts: None,
            is_round_off: false,
            is_jump: false,
            is_apart: false,
            is_paced: true,
            of_states: None,
            imbalance: balance.error,
            work_error: 0.0,
            passage: Passage {
                steps,
                margins,
                seen: None,
            },
        }
    }
}

/// What the error of a pair is measured by, in sizes and radians.
struct Bounds {
    /// The way of the pair.
    way: f64,
    /// Round-off of velocities, as displacements in half of the pair.
    noise: f64,
    /// The error of this that is allowed.
    allowed: f64,
    /// The same of positions.
    of_positions: f64,
    states: Pair,
    /// What shows a jump, where there can be one.
    signs: Option<Signs>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Two steps, the first of h, which stay, and others over the same time to compare them with. Their error may be that of a
    /// pair of `reach` seconds, and round-off may be larger than expected by the factor `indulgence`; `previous` is what the pairs
    /// before were like.
    pub(super) fn compare(
        &mut self,
        tolerance: f64,
        (h, left): (f64, f64),
        (reach, indulgence): (f64, f64),
        (controller, previous, start): (&StepController, Previous, RankMargin),
        (shortest, last): (f64, bool),
    ) -> Result<Found, SimulationError> {
        let rejected_before = self.rejected;
        let first = self.guarded_step(h, left)?;
        let of_first = self.integrator.estimate();
        let seen_by_first = self.seen_pose().map(|pose| pose * first);
        let middle = self.margin();
        let mut found = Found::before([first, first], [start, middle, middle], &self.balance);
        found.as_chosen = first == h;
        found.is_paced = controller.step >= PACED * self.settings.step;
        let rest = left - first;
        let by_steps = self.follows() && self.pace() == Pace::Steps;
        let mut next = h;
        if found.as_chosen && self.follows() && !self.is_determined() {
            let span = (tolerance, first, (reach, indulgence));
            let estimated = (controller, of_first.map(|estimate| estimate.error));
            found.error_ratio = self.error_ratio_of_first(span, [start, middle], estimated);
            // The second step would not make it better.
            if found.error_ratio > TOO_MUCH {
                found.is_embedded = true;
                return Ok(found);
            }
            if by_steps && !found.error_ratio.is_nan() {
                let order = self.settings.true_order();
                (next, found.difficulty_of_first) = controller.second(order, h, found.error_ratio);
                next = if next < NEARLY * rest { next } else { rest };
            }
        }
        let second = self.guarded_step(next.min(rest), rest)?;
        let of_second = self.integrator.estimate();
        let seen_by_second = self.seen_pose().map(|pose| first + pose * second);
        // The estimate of a step that was halved is that of its last part alone.
        let both = of_first
            .zip(of_second)
            .filter(|_| self.rejected == rejected_before);
        let of_pair = both.map(|(first, second)| first.plus(second));
        found.work_error = of_pair.map_or(0.0, |pair| pair.work);
        found.parts = both
            .zip(of_pair.filter(|pair| pair.error > 0.0))
            .map(|((first, second), pair)| [first, second].map(|step| step.error / pair.error));
        let end = self.margin();
        let noise = indulgence * self.noise(start, end);
        let length = first + second;
        found.speed = self.speed(length);
        found.as_chosen = first == h && second == next;
        found.passage = Passage {
            steps: [first, second],
            margins: [start, middle, end],
            seen: seen_by_first.or(seen_by_second),
        };
        let way = length.max(reach) * found.speed.max(controller.speed);
        let carried = self.noise_of_velocities(noise, 0.5 * length, controller);
        let [of_positions, allowed] =
            [noise, carried].map(|noise| self.allowed(tolerance, way, noise));
        // Steps to a pose of which it is not known that it is singular may have left their branch, which no embedded method sees.
        let keeps_its_branch = self.keeps_its_branch(&found);
        let of_pair = of_pair.filter(|_| keeps_its_branch);
        let estimate = of_pair.map(|pair| pair.error);
        // The estimate of the motion does not show the errors of states, but the jumps of forces.
        found.is_embedded = self.is_estimated && keeps_its_branch;
        let of_error = estimate.filter(|_| found.is_embedded);
        found.error_ratio = controller.predicted_error_ratio(of_error, allowed);
        if found.is_embedded && self.follows() && self.is_determined() {
            found.error_ratio = 0.0;
            return Ok(found);
        }
        let (clearly, most) = match (by_steps, self.follows()) {
            (true, _) => (CLEARLY[0], UNCOMPARED[0]),
            (_, true) => (CLEARLY[1], UNCOMPARED[1]),
            _ => (CLEARLY[1], UNCOMPARED[2]),
        };
        let signs = self.signs(previous, of_pair, (length, allowed, carried));
        found.estimated_difficulty = signs.and_then(|signs| signs.difficulty());
        let may_jump = signs.is_some_and(|signs| signs.may_jump());
        let is_recent = controller.pairs_since_comparison < most;
        let is_clear = found.error_ratio <= clearly && is_recent && !may_jump;
        if is_clear || found.error_ratio > TOO_MUCH && self.follows() {
            return Ok(found);
        }
        self.pair_end.copy_from(self.integrator.state());
        let kept = self.keep();
        found.error_ratio = f64::NAN;
        found.difficulty_of_first = None;
        let bounds = Bounds {
            way,
            noise: carried,
            allowed,
            of_positions,
            states: Pair {
                steps: found.passage.steps,
                share: SHARE * tolerance,
                way,
                noise,
                estimates: of_pair.map_or([0.0; 2], |pair| pair.of_states),
                is_shortest: h <= 2.0 * shortest,
            },
            signs,
        };
        let outcome = self.measure(&mut found, controller, &bounds, (estimate, last));
        // Where the estimate tells no error, pairs without signs of a jump are compared, too.
        if may_jump || found.is_jump && !self.is_estimated {
            if signs.is_some_and(|signs| signs.is_blind(found.measured_factor)) {
                found.error_ratio = found.error_ratio.max(TOO_LONG);
            }
            // The factor of smooth motion is not smaller because of a jump.
            let usual = controller.estimate_factor;
            let is_sudden = signs.is_some_and(|signs| signs.is_sudden());
            let larger = |factor: f64| match (found.is_jump && usual > 0.0, is_sudden) {
                (true, _) => factor.clamp(usual, UNUSUAL * usual),
                (false, true) => factor.max(usual),
                (false, false) => factor,
            };
            found.estimate_factor = found.estimate_factor.map(larger);
        }
        self.integrator.state_mut().copy_from(&self.pair_end);
        self.restore(kept)?;
        outcome.map(|()| found)
    }

    /// The ratio of the error of the first step to the allowed one by its estimate; NaN if the factor of that is not known.
    fn error_ratio_of_first(
        &self,
        (tolerance, first, (reach, indulgence)): (f64, f64, (f64, f64)),
        [start, middle]: [RankMargin; 2],
        (controller, estimate): (&StepController, Option<f64>),
    ) -> f64 {
        let share = SHARE * tolerance * first.max(reach);
        let noise = indulgence * self.noise(start, middle);
        // Only where the greatest speed so far is not enough the present one is needed.
        let allowed = noise.max(share * controller.speed);
        let error_ratio = controller.predicted_error_ratio(estimate, allowed);
        if error_ratio <= TOO_MUCH || error_ratio.is_nan() {
            return error_ratio;
        }
        controller.predicted_error_ratio(estimate, allowed.max(share * self.speed(first)))
    }

    /// Takes other steps over the time of the pair, and notes its error.
    fn measure(
        &mut self,
        found: &mut Found,
        controller: &StepController,
        bounds: &Bounds,
        (estimate, last): (Option<f64>, bool),
    ) -> Result<(), SimulationError> {
        let pair = found.passage.steps;
        let length: f64 = pair.into_iter().sum();
        let order = i32::from(self.settings.true_order());
        // As if the motion were as difficult in all steps: where the steps of the pair differ because it is not, the error is
        // overestimated. (An estimate of the difficulties gave no better steps.) Relative to the length: powers of a short step
        // vanish.
        let error = |steps| error_of(steps, length, order);
        // At rest the motion, too, is noise; a force that jumps all the time is noise only to steps as short as these.
        let is_next_to_clock = controller.step < NEAR_CLOCK * CLOCK * self.pair_start.time.abs();
        let still = match found.is_paced {
            false if controller.still_pairs >= STILL_PAIRS => 0.0,
            // At large times the clock does not tell the instant of a jump better than by such a way.
            _ if is_next_to_clock => bounds.noise.max(self.settings.constraint_tolerance),
            _ => bounds.noise,
        };
        let partitions = match self.follows() {
            true => ESTIMATED,
            false => PARTITIONS.len(),
        };
        let work_of_pair = self.balance.nonconservative_work;
        let mut converged = false;
        for fraction in PARTITIONS.into_iter().take(partitions) {
            let steps = [fraction * length, (1.0 - fraction) * length];
            let ratio = error(steps) / error(pair) - 1.0;
            if ratio < TELLING {
                continue;
            }
            let Some(clearance) = self.others(steps)? else {
                continue;
            };
            converged = true;
            // Where nothing is allowed 0/0 is not a number, of which `min` makes 1.
            let weight = (bounds.allowed / bounds.of_positions).min(1.0);
            let (apart, mut worst) = self.apart(0.5 * length, weight);
            found.is_apart = apart > UNLIKE * bounds.way;
            if const { Self::DRIVEN } {
                let off = (self.balance.nonconservative_work - work_of_pair).abs();
                found.work_error = found.work_error.max(off / ratio);
            }
            found.is_round_off = apart <= bounds.noise;
            let mut of_motion = match (found.is_apart, apart > still) {
                (true, true) => TOO_LONG,
                (true, false) => apart / (ratio * bounds.allowed.max(still)),
                (false, _) => apart / (ratio * bounds.allowed),
            };
            let factor = estimate.map(|estimate| apart / ratio / estimate);
            let is_jump = bounds
                .signs
                .is_some_and(|signs| signs.is_jump(of_motion, factor));
            found.is_jump = is_jump;
            if is_jump {
                of_motion = over_a_jump(of_motion, ratio);
            }
            let mut error_ratio = of_motion;
            if let Some(own) =
                self.errors_of_states(&bounds.states, (ratio, is_jump), controller)?
            {
                found.of_states = Some(own.seen);
                if own.error_ratio > error_ratio {
                    (error_ratio, worst) = (own.error_ratio, own.velocity);
                }
            }
            if error_ratio <= 1.0 || last || !(clearance < self.clear()) {
                found.error_ratio = error_ratio;
                let worst = S::MODEL.velocities.get(worst);
                found.of = worst.map_or(ErrorOf::Motion, |worst| ErrorOf::Velocity(worst.name));
                let error = match self.follows() {
                    true => apart / ratio,
                    false => of_motion.max(TOO_SMALL) * bounds.allowed,
                };
                found.measured_factor = factor;
                let factor = estimate.map(|estimate| error / estimate);
                found.estimate_factor = factor.filter(|factor| factor.is_finite());
                break;
            }
        }
        if !converged {
            found.error_ratio = TOO_LONG;
        }
        Ok(())
    }

    /// Whether the pair passes no singular pose, or one that is known, with steps that end far from it. Their velocities then
    /// are those of one branch.
    fn keeps_its_branch(&self, found: &Found) -> bool {
        if const { Self::UNBRANCHED } {
            return true;
        }
        let passage = &found.passage;
        if !passage.has_same_rows() {
            return false;
        }
        let length: f64 = passage.steps.into_iter().sum();
        match passage.pose() {
            None if found.as_chosen => true,
            pose => {
                let is_known = |pose: f64| self.is_known(&self.pair_start, pose / length, SAME);
                passage.margins.iter().all(|margin| margin.least > FAR) && pose.is_none_or(is_known)
            }
        }
    }

    /// The pose that the stages of the last step have seen, as a fraction of the step.
    fn seen_pose(&self) -> Option<f64> {
        match const { Self::UNBRANCHED } {
            true => None,
            false => self.integrator.pose_within(),
        }
    }

    /// The error that is allowed on a way, in sizes and radians.
    pub(super) fn allowed(&self, tolerance: f64, way: f64, noise: f64) -> f64 {
        (SHARE * tolerance * way).max(noise)
    }

    /// Round-off between instants with these rank margins, in sizes and radians.
    pub(super) fn noise(&self, start: RankMargin, end: RankMargin) -> f64 {
        let exact = (self.yardstick).round_off_of_positions(self.positions());
        let clock = match const { Self::DRIVEN } {
            true => self.way_of_clock(),
            false => 0.0,
        };
        if const { Self::UNBRANCHED } {
            return exact + clock;
        }
        let least = end.least.min(start.least).max(WEAKEST);
        let left = match self.follows() && least > PROJECTED[1] {
            true => PROJECTED[0] * self.settings.constraint_tolerance,
            false => self.settings.constraint_tolerance,
        };
        left.max(exact) / least + clock
    }

    /// Round-off of velocities times h, in sizes and radians; `noise` is that of positions. Velocities have the round-off of forces,
    /// times the step, and their own: in steps shorter than usual this is less than `noise` / h. (Where it is allowed all the same a
    /// force a that jumps leaves errors of √(a · `noise`) in velocities.) Rows leave velocities an error of their own, and steps
    /// next to the clock have no shorter ones.
    pub(super) fn noise_of_velocities(
        &self,
        noise: f64,
        h: f64,
        controller: &StepController,
    ) -> f64 {
        let shortest = SHORTEST * self.settings.step + CLOCK * self.pair_start.time.abs();
        if const { R > 0 } || h < NEAR_CLOCK * shortest {
            return noise;
        }
        let [before, now] = [&self.pair_start.velocities, self.velocities()]
            .map(|velocities| self.size(velocities));
        let own = 2.0 * h * ROUND_OFF * before.max(now);
        (noise * h / controller.usual).max(own).min(noise)
    }

    /// The way v · 2 ε |t| within the round-off of the clock, in sizes and radians: rows of time are satisfied at the instants that it
    /// shows, those of stages too.
    fn way_of_clock(&self) -> f64 {
        let [before, now] = [&self.pair_start.velocities, self.velocities()]
            .map(|velocities| self.yardstick.measure(velocities));
        2.0 * f64::EPSILON * self.time().abs() * before.max(now)
    }

    /// How far the rows are from losing their independence, 1 at most.
    pub(super) fn margin(&mut self) -> RankMargin {
        let known = self.rank_margin;
        let now = known.or_else(|| self.integrator.rank_margin());
        now.map_or(RankMargin::FULL, |now| RankMargin {
            least: now.least.min(1.0),
            ..now
        })
    }

    /// From the beginning of the pair in other steps; their least clearance, or `None` if one does not converge.
    pub(super) fn others(&mut self, steps: [f64; 2]) -> Result<Option<f64>, SimulationError> {
        self.integrator.state_mut().copy_from(&self.pair_start);
        self.rank_margin = None;
        self.integrator.refresh(&self.settings)?;
        let rejected = self.rejected;
        let mut least = f64::INFINITY;
        for step in steps.into_iter().filter(|step| *step > 0.0) {
            match self.advance(step) {
                Ok(clearance) => least = least.min(clearance),
                Err(error) if error.asks_for_less() => return Ok(None),
                Err(SimulationError::NonFinite { .. }) => return Ok(None),
                Err(error) => return Err(error),
            }
        }
        Ok((self.rejected == rejected).then_some(least))
    }

    /// In sizes and radians; infinite if any entry is not a number.
    pub(super) fn size(&self, x: &SVector<f64, N>) -> f64 {
        let size = self.yardstick.measure(x);
        if size.is_nan() { f64::INFINITY } else { size }
    }

    /// The distance between the results of the other steps and of the pair, in sizes and radians, of positions times `weight`, and
    /// the velocity with the largest part.
    fn apart(&self, h: f64, weight: f64) -> (f64, usize) {
        let (pair, other) = (&self.pair_end, self.state());
        let q = self.system().difference(&pair.positions, &other.positions);
        let v: SVector<f64, N> = vector(|i| h * (other.velocities[i] - pair.velocities[i]));
        let (moved, carried) = (weight * self.size(&q), self.size(&v));
        match moved >= carried {
            true => (moved, self.yardstick.worst(&q)),
            false => (carried, self.yardstick.worst(&v)),
        }
    }
}
