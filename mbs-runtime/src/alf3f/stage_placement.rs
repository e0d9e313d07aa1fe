//! The ends of the stages of a composed step relative to a singular pose, and the step length with the largest distance
//! from it.
//!
//! Beside a singular pose σ_min of the rows is the distance from it, up to a factor:
//!
//! ```text
//! σ = k |y − p|        p: landing, y: the pose, both as fractions of the step from its beginning
//! ```
//!
//! σ at the beginning and at the end of the step gives y. The fractions p of all stages are known, so that the length
//! with the largest gap around the pose is computed without trial steps.

use crate::memory::StageList;
use crate::singular::RankMargin;

/// The clearance, as a fraction of the step, above which the step is accepted; below it another length can be better.
pub(crate) const CLEAR: f64 = 0.06;
/// The number of lengths to choose from.
const CHOICES: u32 = 66;
/// A length that differs by less than this fraction from that of the step has nearly the same ends of stages.
const SAME: f64 = 0.01;
/// The distance before the pose that the next step needs at its beginning, as a fraction of a step, and the weight of a
/// smaller distance.
pub(crate) const ROOM: f64 = 0.2;
pub(crate) const LACK: f64 = 0.3;
/// A pose farther away than this fraction of the step is ignored.
const AHEAD: f64 = 1.5;

/// The rank margins at the ends of the stages of a step.
#[derive(Debug, Clone)]
pub(crate) struct StagePlacement {
    /// Fractions of a step.
    places: StageList<f64>,
    start: RankMargin,
    seen: StageList<RankMargin>,
    /// Where the singular pose is, as a fraction of the step; infinite where there is none.
    pose: f64,
}

impl StagePlacement {
    /// For a composition of these stages.
    pub(crate) fn new(stages: &[f64]) -> Self {
        let mut place = 0.0;
        let places = stages.iter().map(|stage| {
            place += stage;
            place
        });
        StagePlacement {
            places: places.collect(),
            start: RankMargin::FULL,
            seen: StageList::with_capacity(stages.len()),
            pose: f64::INFINITY,
        }
    }

    /// A step begins here.
    pub(crate) fn begin(&mut self, start: RankMargin) {
        self.start = start;
        self.seen.clear();
        self.pose = f64::INFINITY;
    }

    pub(crate) fn add(&mut self, landing: RankMargin) {
        self.seen.push(landing);
    }

    /// After the last stage: the distance of the nearest end of a stage from a singular pose, as a fraction of the
    /// step; infinite without one.
    pub(crate) fn settle(&mut self) -> f64 {
        let (pose, nearest) = self.find();
        self.pose = pose;
        match pose > 0.0 {
            true => self.clearance(1.0, pose).min(nearest),
            // The pose is behind the step; the step before has treated it.
            false => f64::INFINITY,
        }
    }

    /// The position of the pose, and the distance of the nearest end of a stage from it according to σ, which differs
    /// after a change of branch.
    fn find(&self) -> (f64, f64) {
        // Rows that are redundant everywhere do not count; the ends with more dependent rows are nearest to a pose.
        let all = || self.seen.iter().chain([&self.start]);
        let fewest = all().map(|landing| landing.lost).min().unwrap_or(0);
        let sigma = |landing: &RankMargin| match landing.lost == fewest {
            true => landing.sigma,
            false => landing.weakest,
        };
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for value in all().map(sigma) {
            least = least.min(value);
            most = most.max(value);
        }
        let Some(end) = self.seen.last().map(sigma) else {
            return (f64::INFINITY, f64::INFINITY);
        };
        let start = sigma(&self.start);
        // The end of a step that has the pose 1.5 lengths from its beginning is at a third of its σ.
        if !(least < (1.0 - 1.0 / AHEAD) * most) {
            return (f64::INFINITY, f64::INFINITY);
        }
        let misfit = |pose: f64| -> f64 {
            let rate = most / self.farthest(pose);
            let pairs = self.places.iter().zip(&self.seen);
            pairs
                .map(|(place, seen)| (rate * (pose - place).abs() - sigma(seen)).abs())
                .sum()
        };
        // The pose is within the step, ahead of it, or behind it.
        let (passed, ahead) = (start / (start + end), start / (start - end));
        // (Of two equal ends the pose is in the middle, and there is none ahead.)
        let pose = match misfit(ahead) < misfit(passed) {
            true => ahead,
            false => passed,
        };
        let landed = self.seen.iter().map(sigma).fold(f64::INFINITY, f64::min);
        (pose, landed / most * self.farthest(pose))
    }

    fn farthest(&self, pose: f64) -> f64 {
        let distances = self.places.iter().map(|place| (pose - place).abs());
        distances.fold(pose.abs(), f64::max)
    }

    /// The distance of the nearest end of a stage from the pose for a step of this length, reduced if the next step
    /// begins shortly before the pose.
    fn clearance(&self, length: f64, pose: f64) -> f64 {
        let distances = self
            .places
            .iter()
            .map(|place| (pose - length * place).abs());
        let nearest = distances.fold(f64::INFINITY, f64::min);
        let before = pose - length;
        if before > 0.0 && before < ROOM {
            nearest.min(LACK * before)
        } else {
            nearest
        }
    }

    /// The length, as a fraction of the step and between these bounds, with the largest clearance from the pose, and that
    /// clearance; `None` without a pose.
    pub(crate) fn aim(&self, [shortest, longest]: [f64; 2]) -> Option<(f64, f64)> {
        let lengths = (0..CHOICES).map(|choice| {
            let part = f64::from(choice) / f64::from(CHOICES - 1);
            longest + part * (shortest - longest)
        });
        let others = lengths.filter(|length| (length - 1.0).abs() > SAME);
        let cleared = others.map(|length| (length, self.clearance(length, self.pose)));
        let best = cleared.max_by(|a, b| a.1.total_cmp(&b.1));
        best.filter(|_| self.pose.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::super::composition::stages;
    use super::*;

    fn placement(order: u8, pose: f64) -> StagePlacement {
        let sigma = |place: f64| RankMargin::of(0.01 * (place - pose).abs());
        let mut placement = StagePlacement::new(stages(order));
        placement.begin(sigma(0.0));
        for place in placement.places.clone() {
            placement.add(sigma(place));
        }
        placement
    }

    #[test]
    fn the_pose_is_found() {
        for order in [4, 6, 8] {
            for pose in [0.1, 0.4, 0.5, 0.55, 0.9, 1.1, 1.4] {
                let (found, _) = placement(order, pose).find();
                assert!((found - pose).abs() < 1e-9, "{order}: {found} for {pose}");
            }
            assert_eq!(placement(order, 3.0).find().0, f64::INFINITY);
        }
    }

    /// The least distance from the pose of any end of a stage, for steps of length 1 with placement, through the pose.
    fn nearest_on_the_way(order: u8, pose: f64) -> f64 {
        let (mut begin, mut nearest) = (0.0, f64::INFINITY);
        while begin < pose + 2.0 {
            let mut placement = placement(order, pose - begin);
            let clear = placement.settle() >= CLEAR;
            let aimed = placement.aim([0.5, 1.15]).filter(|_| !clear);
            let length = aimed.map_or(1.0, |(length, _)| length);
            for place in &placement.places {
                nearest = nearest.min((pose - begin - length * place).abs());
            }
            begin += length;
        }
        nearest
    }

    #[test]
    fn no_way_lands_near_a_pose() {
        for order in [4, 6, 8] {
            let poses = (0..3000).map(|i| 3.0 + f64::from(i) / 3000.0);
            let least = poses.map(|pose| nearest_on_the_way(order, pose));
            let least = least.fold(f64::INFINITY, f64::min);
            println!("order {order}: {least:.4}");
            assert!(least > 0.025, "order {order}: {least}");
        }
    }
}
