//! Whether a pair of steps has gone through a singular pose, or has leapt over a pose that is nearly one.
//!
//! At a singular pose branches of the motion meet. Beside a pose that is nearly singular they do not: the motion comes
//! close to another branch and turns away from it, within a way that is as small as the least σ of the rows there. A
//! longer step passes straight to the other branch, where its rows hold as well. So do the steps that it is compared
//! with, and the energy is the same on both: neither error nor balance show it.
//!
//! What differs is the least σ between the ends of the steps. Past a singular pose
//!
//! ```text
//! σ² = k² (t − p)² + g²        t: time, p: that of the pose
//! ```
//!
//! with g = 0, otherwise g > 0 on each of the branches. Steps from the beginning of the pair to the minimum of this
//! parabola tell which. They are taken only where σ of the pair itself has a minimum that may be small. The poses of a
//! mechanism of one degree of freedom form a curve, so that each of its singular poses is looked at once.

use super::Simulation;
use super::known_poses::SAME;
use super::pose::{Passage, Probe, minimum};
use crate::singular::RankMargin;
use crate::{SimulationError, System};

/// The least σ of a pose that is not singular, as a multiple of √e for an error e of the position rows, as a
/// displacement: it shifts a row that is quadratic in the distance from the pose by √e.
const SINGULAR: f64 = 30.0;
/// A pair may begin or end at this multiple of the least σ between. With a larger value a pair may pass the pose as if
/// the branches met; a smaller one takes shorter steps there.
pub(super) const LEAP: f64 = 8.0;
/// Probes of a pair, at most: two are usual at a singular pose. (Probes of one stage instead of a step were tried: they
/// end too far from the motion, and one run in ninety of `tests/near_singular.rs` took the wrong branch.)
const PROBES: usize = 8;
/// The minimum of the parabola is no other than the least probe if σ² there is more than this fraction.
const FOUND: f64 = 0.5;

/// What probes have found.
pub(super) enum Pose {
    /// A singular pose.
    Singular,
    /// A pose that is nearly singular: g, the least σ, and k.
    Turn { least: f64, rate: f64 },
    /// σ has no minimum where it was looked for.
    Unclear,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Whether it has no position rows, and with that no singular pose.
    pub(super) const UNBRANCHED: bool = S::STRUCTURE.holonomic_rows == 0;

    /// Whether the pair of steps that has just been taken passes a pose that is nearly singular as if it were singular.
    #[inline]
    pub(super) fn leaps(&mut self, passage: &Passage) -> Result<bool, SimulationError> {
        if const { Self::UNBRANCHED } {
            return Ok(false);
        }
        match passage.pose() {
            Some(pose) => {
                let [first, second] = passage.steps;
                match self.is_known(&self.pair_start, pose / (first + second), SAME) {
                    true => Ok(false),
                    false => self.look_between(passage, pose),
                }
            }
            None => Ok(false),
        }
    }

    #[cold]
    #[inline(never)]
    fn look_between(&mut self, passage: &Passage, pose: f64) -> Result<bool, SimulationError> {
        let kept = self.keep();
        self.pair_end.copy_from(self.integrator.state());
        let [first, second] = passage.steps;
        let pose = self.find(passage, pose, [0.0, first + second]);
        self.integrator.state_mut().copy_from(&self.pair_end);
        self.restore(kept)?;
        let [start, _, end] = passage.margins;
        let far = start.least.max(end.least);
        Ok(matches!(pose?, Pose::Turn { least, .. } if far > LEAP * least))
    }

    /// The pose between two times of the pair, about `pose`. `self.pair_start` is the state at the first of them.
    pub(super) fn find(
        &mut self,
        passage: &Passage,
        pose: f64,
        [from, to]: [f64; 2],
    ) -> Result<Pose, SimulationError> {
        let singular = self.least_distinct();
        let [first, second] = passage.steps;
        let length = first + second;
        let [start, middle, end] = passage.margins;
        let mut probes = [
            Probe::new(0.0, start),
            Probe::new(first, middle),
            Probe::new(length, end),
        ];
        let (mut time, mut seen, mut rate) = (pose, 0, f64::INFINITY);
        for _ in 0..PROBES {
            Probe::sort(&mut probes);
            let Some(margin) = self.probe(time - from)? else {
                // A step that ends there does not converge.
                time = 0.5 * (time + probes[0].time.max(from));
                continue;
            };
            if margin.dependent != middle.dependent || margin.least <= singular {
                let state = self.integrator.state_mut();
                state.known_poses.add(state.positions);
                return Ok(Pose::Singular);
            }
            seen += 1;
            probes[2] = Probe::new(time, margin);
            Probe::sort(&mut probes);
            let Some(foreseen) = minimum(probes) else {
                break;
            };
            // The first parabola may be through points that are far from the pose.
            let found = seen > 1 && foreseen.square > FOUND * probes[0].square;
            time = probes[0].time + foreseen.way;
            rate = foreseen.rate;
            if found || !(time > from && time < to) {
                break;
            }
        }
        let Probe { time, square } = probes[0];
        let inside = seen > 0 && time > from && time < to;
        let least = square.sqrt();
        Ok(match inside && rate.is_finite() {
            true => Pose::Turn { least, rate },
            false => Pose::Unclear,
        })
    }

    /// The least σ of a pose that can be told from a singular one.
    pub(super) fn least_distinct(&self) -> f64 {
        let exact = (self.yardstick).round_off_of_positions(&self.step_start.positions);
        SINGULAR * self.settings.constraint_tolerance.max(exact).sqrt()
    }

    /// The rank margin some seconds after `self.pair_start`; `None` if no step leads there.
    fn probe(&mut self, span: f64) -> Result<Option<RankMargin>, SimulationError> {
        self.integrator.state_mut().copy_from(&self.pair_start);
        self.rank_margin = None;
        self.integrator.refresh(&self.settings)?;
        match self.advance(span) {
            Ok(_) => Ok(Some(self.margin())),
            Err(error) if error.asks_for_less() => Ok(None),
            Err(SimulationError::NonFinite { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }
}
