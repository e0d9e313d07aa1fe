//! Steps chosen by a tolerance ([`Settings::tolerance`](crate::Settings::tolerance)).
//!
//! Steps come in pairs. Each pair is compared with other steps over the same time, as a rule with a single one of 2h: of
//! order p it has 2ᵖ times the error e of the pair, so that the two differ by (2ᵖ − 1) e. The pair is kept where
//!
//! ```text
//! e ≤ share · tolerance · max(|Δq|, 2h · greatest speed so far)
//! ```
//!
//! with h |Δv| counted like Δq. The length h stays the same until one comparison requires a shorter one, or several in
//! a row allow a longer one: a symmetric method keeps its long-time behaviour as long as its step length does not
//! follow the motion (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, section VIII.2). Lengths are
//! powers of 2^¼ times the first one.
//!
//! Not every pair is compared: a comparison tells by which factor an estimate from the stages differs from the error, and the
//! pairs that follow use this factor.
//!
//! | method | estimate | lengths |
//! |---|---|---|
//! | two-level, orders 4 to 8 | `alf3f/embedded.rs`; where forces depend on velocities, the distance of two means of `alf3f/extrapolation.rs`. It shows only that the motion is still the one of the last comparison: the factor counts for pairs of the same length, and no pair is rejected without a comparison | constant |
//! | explicit, Radau | embedded method | follow the motion (`step_controller.rs`): they are not symmetric, and gain nothing by constant steps |
//!
//! If the steps of a comparison end beside a singular pose, they have an additional error. It is then made with two
//! unequal steps, and after these with a shorter pair.
//!
//! A pair that leaps over a pose that is nearly singular is not kept, though its error seems small (`passage.rs`).

use super::Simulation;
use super::known_poses::SAME;
use super::pose::{FAR, Passage};
use super::step_controller::{Pace, TOO_LONG, notches};
use crate::linear::vector;
use crate::singular::{ROUND_OFF, RankMargin};
use crate::{Energy, ErrorOf, Method, SimulationError, StepController, System};
use nalgebra::SVector;

/// The part of the tolerance that a pair may use: errors of tens of radians of motion add up, and grow with it.
const SHARE: f64 = 0.02;
/// A difference above this fraction of the motion is too large for an error estimate by the order.
const UNLIKE: f64 = 0.3;
/// The steps with which a pair is compared: one of its whole length, otherwise two unequal ones, divided at these
/// fractions.
const PARTITIONS: [f64; 4] = [1.0, 0.3, 0.7, 0.2];
/// As many of them where an embedded method estimates the error: the others have hardly ever led to a pair that was kept.
const ESTIMATED: usize = 2;
/// Other steps whose error is not larger than that of the pair by at least this fraction give no estimate.
const TELLING: f64 = 0.2;
/// Where steps have constant lengths, an excess below this counts as this: it is mostly round-off.
const TOO_SMALL: f64 = 1e-3;
/// Lengths of pairs, as fractions of h, that are tried if a singular pose spoils every comparison.
const SIDESTEPS: [f64; 4] = [1.0, 0.84, 0.71, 0.59];
/// Round-off of the position rows grows by 1/σ beside a singular pose, up to the reciprocal of this.
const WEAKEST: f64 = 1e-5;
/// Corrections of explicit steps square what is left of the rows, and most end far below their tolerance: this part of it is
/// expected, where σ is above the second number. Closer to a pose velocities have other errors.
const PROJECTED: [f64; 2] = [0.1, 1e-3];
/// Pairs without a comparison in a row, at most, where lengths follow the motion and where they are constant. With more of them
/// the factor of the estimate is that of another part of the motion.
const UNSEEN: [u32; 2] = [15, 7];
/// The excess of an estimate, times the last factor, up to which a pair is kept without a comparison, …
const CLEARLY: f64 = 0.5;
/// … and from which on it is not kept, where lengths follow the motion.
const TOO_MUCH: f64 = 1.0;
/// Where σ is below this, velocities have errors from the pose that no shorter step removes. After so many attempts from one
/// instant, and each further one, this factor more of round-off is allowed, and the error of the first pair that was tried. (Up
/// to 20 times the round-off that is expected was found, at σ = 6e-4.)
const BESIDE: f64 = 0.02;
const ATTEMPTS: u32 = 3;
const INDULGENCE: [f64; 2] = [4.0, 64.0];
/// Steps of any length agree about a motion that rows of time determine, and may agree about another branch beyond a singular
/// pose. What tells them apart is the energy balance: a pair may be wrong by this part of the kinetic energy, or of the work
/// of forces without potential (in regular poses a driven mechanism has the tolerance instead of this part), …
const BALANCED: f64 = 0.02;
/// … and the velocities of a driven mechanism may change by this part of the speed past a singular pose, …
const TURNED: f64 = 0.5;
/// … unless it moves less than this, in sizes and radians: where a drive jumps the balance is wrong in any step.
const NEARBY: f64 = 0.002;
/// Steps shorter than this part of the first one that may be tried are not.
const SHORTEST: f64 = 1e-9;
/// The least step, as a part of the first one, with which a mechanism can be at rest.
const PACED: f64 = 1e-5;

/// What a comparison found.
struct Found {
    /// The ratio of the error to the allowed error; NaN if singular poses prevent the estimate.
    excess: f64,
    /// What has this excess.
    of: ErrorOf,
    /// Sizes and radians a second.
    speed: f64,
    /// Whether the pair had its two equal steps.
    even: bool,
    /// The factor of the embedded estimate, if the pair was compared.
    gauge: Option<f64>,
    /// Whether the stages give an estimate of the error of this pair.
    is_embedded: bool,
    /// The error of the energy balance after the first step, J.
    imbalance: f64,
    passage: Passage,
}

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
        match self.settings.tolerance {
            None => self.place(h, left).map(drop),
            Some(tolerance) => self.chosen_pair(tolerance, left),
        }
    }

    /// Two steps of h, and of shorter ones until their error is small enough.
    pub(super) fn pair(&mut self, tolerance: f64, left: f64) -> Result<Passage, SimulationError> {
        let mut step_controller = self.state().step_controller;
        if step_controller.step == 0.0 {
            step_controller = StepController::starting(self.settings.step);
        }
        let (books, balance) = (self.books, self.balance);
        self.pair.copy_from(self.integrator.state());
        let margin = self.margin();
        let (mut sidestep, mut attempts, mut reach) = (0, 0, 0.0);
        let clock = 1e-13 * self.pair.time.abs();
        let shortest = clock.max(SHORTEST * self.settings.step.min(0.5 * left));
        loop {
            let h = SIDESTEPS[sidestep] * step_controller.step.min(0.5 * left);
            let last = sidestep + 1 == SIDESTEPS.len();
            if attempts == 0 {
                reach = 2.0 * h;
            }
            let persists = attempts >= ATTEMPTS && margin.least < BESIDE;
            let allowance = if persists {
                let more = INDULGENCE[0].powi((attempts - ATTEMPTS + 1) as i32);
                (reach, more.min(INDULGENCE[1]))
            } else {
                (0.0, 1.0)
            };
            let controller = (&step_controller, margin);
            let found = self.compare(tolerance, (h, left), allowance, controller, last);
            let order = self.settings.true_order();
            let (excess, is_embedded, error) = match found {
                Ok(mut found) => {
                    if found.excess <= 1.0 && self.leaps(&found.passage)? {
                        (found.excess, found.of) = (TOO_LONG, ErrorOf::Branch);
                    }
                    if found.excess <= 1.0 {
                        let imbalance = self.imbalance(tolerance, &balance, &found);
                        if imbalance > found.excess {
                            (found.excess, found.of) = (imbalance, ErrorOf::Balance);
                        }
                    }
                    if found.excess <= 1.0 {
                        step_controller.speed = step_controller.speed.max(found.speed);
                        step_controller.note(found.gauge, found.excess, self.follows());
                        if h == step_controller.step && found.is_embedded && self.follows() {
                            let [first, second] = found.passage.steps;
                            let mean = 0.5 * (first + second);
                            step_controller.follow(order, mean, found.excess, self.pace());
                        } else if h == step_controller.step && found.even && !self.follows() {
                            step_controller.lengthen(notches(order, found.excess));
                        }
                        self.integrator.state_mut().step_controller = step_controller;
                        return Ok(found.passage);
                    }
                    let error = SimulationError::Tolerance {
                        time: self.pair.time,
                        step: h,
                        tolerance,
                        times: found.excess,
                        of: found.of,
                    };
                    (found.excess, found.is_embedded, error)
                }
                Err(error) if error.is_due_to_steps() => (TOO_LONG, false, error),
                Err(error) => return Err(error),
            };
            self.rejected += 1;
            self.integrator.state_mut().copy_from(&self.pair);
            (self.books, self.rank_margin) = (books, None);
            self.integrator.refresh(&self.settings)?;
            if excess.is_nan() && !last {
                sidestep += 1;
                continue;
            }
            sidestep = 0;
            let excess = if excess.is_nan() { TOO_LONG } else { excess };
            match is_embedded && self.follows() {
                true => step_controller.retreat(order, h, excess, (attempts > 0, self.pace())),
                false => step_controller.shorten(h, notches(order, excess)),
            }
            attempts += 1;
            if !(step_controller.step > shortest) {
                return Err(error);
            }
        }
    }

    /// Two steps of h, which stay, and others over the same time to compare them with. Their error may be that of a pair of
    /// `reach` seconds, and round-off may be larger than expected by the factor `indulgence`.
    fn compare(
        &mut self,
        tolerance: f64,
        (h, left): (f64, f64),
        (reach, indulgence): (f64, f64),
        (controller, start): (&StepController, RankMargin),
        last: bool,
    ) -> Result<Found, SimulationError> {
        let first = self.place(h, left)?;
        let mut estimate = self.integrator.estimate();
        let middle = self.margin();
        let mut found = Found {
            excess: f64::NAN,
            of: ErrorOf::Motion,
            speed: 0.0,
            even: first == h,
            gauge: None,
            is_embedded: false,
            imbalance: self.balance.error,
            passage: Passage {
                steps: [first, first],
                margins: [start, middle, middle],
            },
        };
        if found.even && self.follows() && !self.is_determined() {
            // In most pairs a part of what is allowed is enough.
            let some = SHARE * tolerance * first.max(reach) * controller.speed;
            if controller.foresees(estimate, some) > TOO_MUCH {
                let way = first.max(reach) * self.speed(first).max(controller.speed);
                let allowed = (SHARE * tolerance * way).max(indulgence * self.noise(start, middle));
                found.excess = controller.foresees(estimate, allowed);
                found.is_embedded = true;
                // The second step would not make it better.
                if found.excess > TOO_MUCH {
                    return Ok(found);
                }
            }
        }
        let second = self.place(h.min(left - first), left - first)?;
        let later = self.integrator.estimate();
        estimate = estimate.zip(later).map(|(first, second)| first + second);
        let end = self.margin();
        let noise = indulgence * self.noise(start, end);
        let length = first + second;
        found.speed = self.speed(length);
        found.even = first == h && second == h;
        found.passage = Passage {
            steps: [first, second],
            margins: [start, middle, end],
        };
        let way = length.max(reach) * found.speed.max(controller.speed);
        let allowed = (SHARE * tolerance * way).max(noise);
        // Steps to a pose of which it is not known that it is singular may have left their branch, which no embedded method sees.
        found.is_embedded = self.is_estimated && self.keeps_its_branch(&found);
        let estimate = estimate.filter(|_| found.is_embedded);
        found.excess = controller.foresees(estimate, allowed);
        if found.is_embedded && self.follows() && self.is_determined() {
            found.excess = 0.0;
            return Ok(found);
        }
        let unseen = UNSEEN[usize::from(!self.follows())];
        let is_clear = found.excess <= CLEARLY && controller.unseen < unseen;
        if is_clear || found.excess > TOO_MUCH && self.follows() {
            return Ok(found);
        }
        self.before.copy_from(self.integrator.state());
        let kept = self.keep();
        found.excess = f64::NAN;
        let order = i32::from(self.settings.true_order());
        // Relative to the length: powers of a short step vanish.
        let power = |h: f64| (h / length).powi(order + 1);
        let error = |steps: [f64; 2]| steps.into_iter().map(power).sum::<f64>();
        // At rest the motion, too, is noise; a force that jumps all the time is noise only to steps as short as these.
        let paced = controller.step >= PACED * self.settings.step;
        let still = if paced { noise } else { 0.0 };
        let mut converged = false;
        let partitions = if self.follows() {
            ESTIMATED
        } else {
            PARTITIONS.len()
        };
        for fraction in PARTITIONS.into_iter().take(partitions) {
            let steps = [fraction * length, (1.0 - fraction) * length];
            let ratio = error(steps) / error([first, second]) - 1.0;
            if ratio < TELLING {
                continue;
            }
            let Some(clearance) = self.others(steps)? else {
                continue;
            };
            converged = true;
            let (apart, mut worst) = self.apart(h);
            let mut excess = match apart > (UNLIKE * way).max(still) {
                true => TOO_LONG,
                false => apart / (ratio * allowed),
            };
            if let Some((own, state)) = self.state_excess((SHARE * tolerance, way), noise)
                && own / ratio > excess
            {
                (excess, worst) = (own / ratio, state);
            }
            if excess <= 1.0 || last || !(clearance < self.clear()) {
                found.excess = excess;
                let worst = S::MODEL.velocities.get(worst);
                found.of = worst.map_or(ErrorOf::Motion, |worst| ErrorOf::Velocity(worst.name));
                let error = match self.follows() {
                    true => apart / ratio,
                    false => excess.max(TOO_SMALL) * allowed,
                };
                let gauge = estimate.map(|estimate| error / estimate);
                found.gauge = gauge.filter(|gauge| gauge.is_finite());
                break;
            }
        }
        if !converged {
            found.excess = TOO_LONG;
        }
        self.integrator.state_mut().copy_from(&self.before);
        self.restore(kept)?;
        Ok(found)
    }

    /// The ratio of the error of the energy balance in the pair to the allowed one; [`TOO_LONG`] where a driven mechanism, whose
    /// balance does not show it, may have turned into another branch.
    ///
    /// Where rows of time determine the motion, positions are exact with steps of any length, but the work of the drives
    /// is not: it is a sum over the stages.
    fn imbalance(&self, tolerance: f64, before: &Energy, found: &Found) -> f64 {
        let [first, second] = found.passage.steps;
        if found.speed * (first + second) < NEARBY {
            return 0.0;
        }
        let now = &self.balance;
        let work = (now.nonconservative_work - before.nonconservative_work).abs();
        let turnover = before.kinetic.max(now.kinetic).max(work);
        let of = |error: f64| (error - before.error).abs();
        let error = of(now.error).max(of(found.imbalance));
        let excess = error / (BALANCED * turnover);
        let excess = match (const { Self::DRIVEN }, found.passage.pose().is_some()) {
            (true, true) if self.turns() => TOO_LONG,
            (true, false) => {
                let turnover = turnover.max((now.drive_work - before.drive_work).abs());
                let whole = now.kinetic + now.potential.abs() + now.drive_work.abs();
                excess.max(error / (tolerance * turnover + ROUND_OFF * whole))
            }
            _ => excess,
        };
        excess.min(TOO_LONG)
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
            None if found.even => true,
            pose => {
                let is_known = |pose: f64| self.is_known(&self.pair, pose / length, SAME);
                passage.margins.iter().all(|margin| margin.least > FAR) && pose.is_none_or(is_known)
            }
        }
    }

    /// Whether the velocities change in the pair so much that it may have turned into another branch. A drive gives the
    /// energy for that.
    fn turns(&self) -> bool {
        let (before, now) = (&self.pair.velocities, self.velocities());
        let measure = |v: &SVector<f64, N>| self.yardstick.measure(v);
        measure(&(now - before)) > TURNED * measure(now).max(measure(before))
    }

    /// Whether steps are controlled by the estimates of an embedded method. A step that fails is then as one whose estimate is
    /// too large: no other lengths are tried, and no halves.
    pub(super) fn is_paced_by_estimates(&self) -> bool {
        self.follows() && self.settings.tolerance.is_some()
    }

    /// Whether rows of time determine the motion: then only the work of drives has an error. (In long two-level steps this work
    /// is right for some lengths and far off for others, which only comparisons show.)
    fn is_determined(&self) -> bool {
        (const { Self::DRIVEN }) && self.assembly.rank == N
    }

    fn pace(&self) -> Pace {
        match self.settings.method {
            Method::Radau => Pace::Kept,
            _ if self.is_determined() => Pace::Erratic,
            _ => Pace::Steady,
        }
    }

    /// Whether lengths of steps follow the motion: those of methods with an estimate that are not symmetric.
    pub(super) fn follows(&self) -> bool {
        self.is_estimated && !matches!(self.settings.method, Method::TwoLevel)
    }

    /// The mean speed from the beginning of the pair, `length` seconds ago, in sizes and radians a second.
    fn speed(&self, length: f64) -> f64 {
        let moved = self
            .system()
            .difference(&self.pair.positions, self.positions());
        self.size(&moved) / length
    }

    /// The way that the last pair goes, or would have gone with steps as long as those in use, in sizes and radians.
    pub(super) fn way(&self) -> f64 {
        let length = self.time() - self.pair.time;
        self.speed(length) * 2.0 * self.nominal()
    }

    /// Round-off between instants with these rank margins, in sizes and radians.
    fn noise(&self, start: RankMargin, end: RankMargin) -> f64 {
        let exact = (self.yardstick).round_off_of_positions(self.positions());
        let least = end.least.min(start.least).max(WEAKEST);
        let left = match self.follows() && least > PROJECTED[1] {
            true => PROJECTED[0] * self.settings.constraint_tolerance,
            false => self.settings.constraint_tolerance,
        };
        left.max(exact) / least
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
    fn others(&mut self, steps: [f64; 2]) -> Result<Option<f64>, SimulationError> {
        self.integrator.state_mut().copy_from(&self.pair);
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
    fn size(&self, x: &SVector<f64, N>) -> f64 {
        let size = self.yardstick.measure(x);
        if size.is_nan() { f64::INFINITY } else { size }
    }

    /// The distance between the results of the other steps and of the pair, in sizes and radians, and the velocity with
    /// the largest part.
    fn apart(&self, h: f64) -> (f64, usize) {
        let (pair, other) = (&self.before, self.state());
        let q = self.system().difference(&pair.positions, &other.positions);
        let v: SVector<f64, N> = vector(|i| h * (other.velocities[i] - pair.velocities[i]));
        let (moved, carried) = (self.size(&q), self.size(&v));
        match moved >= carried {
            true => (moved, self.yardstick.worst(&q)),
            false => (carried, self.yardstick.worst(&v)),
        }
    }
}
