//! Where a singular pose lies in an explicit step, and how far the stages of another length keep away from it.
//!
//! Beside a singular pose the smallest singular value of the rows is the distance from it, up to a factor:
//!
//! ```text
//! σ = k |c − p|        c: a stage, p: the pose, both as fractions of the step from its beginning
//! ```
//!
//! Far from the pose it is not, and a step may be long. So k follows from the stage with the least σ and its neighbours: on the
//! side of the pose σ of both add up, on the other side they differ.

use crate::alf3f::{LACK, ROOM};

/// Stages that are nearer to each other give no slope.
const APART: f64 = 0.04;
/// A pose is looked for in a step in which σ² falls below this part of its largest value.
const FALLEN: f64 = 0.1;

/// σ at the stages of a step.
#[derive(Debug, Clone)]
pub(crate) struct StagePoses {
    /// The fractions of the stages.
    nodes: &'static [f64],
    /// Indices of the stages in the order of their fractions.
    order: Box<[usize]>,
    /// 1/σ² of each.
    inverse_squares: Box<[f64]>,
}

impl StagePoses {
    pub(crate) fn new(nodes: &'static [f64]) -> Self {
        let mut order: Box<[usize]> = (0..nodes.len()).collect();
        order.sort_by(|&a, &b| nodes[a].total_cmp(&nodes[b]));
        StagePoses {
            nodes,
            order,
            inverse_squares: vec![f64::NAN; nodes.len()].into_boxed_slice(),
        }
    }

    /// A step begins: of stages that it does not reach nothing is known.
    pub(crate) fn begin(&mut self) {
        self.inverse_squares.fill(f64::NAN);
    }

    #[inline(always)]
    pub(crate) fn note(&mut self, stage: usize, inverse_square: f64) {
        self.inverse_squares[stage] = inverse_square;
    }

    /// Place and σ of a stage.
    fn seen(&self, stage: usize) -> (f64, f64) {
        (self.nodes[stage], 1.0 / self.inverse_squares[stage].sqrt())
    }

    /// The pose, as a fraction of the step; NaN if the stages do not tell.
    fn pose(&self) -> f64 {
        let stages = || self.order.iter().map(|&stage| self.seen(stage));
        let nearest = stages().min_by(|a, b| a.1.total_cmp(&b.1));
        let (place, least) = nearest.unwrap_or((f64::NAN, f64::NAN));
        let before = stages().rfind(|(other, _)| place - other > APART);
        let after = stages().find(|(other, _)| other - place > APART);
        let (Some(before), Some(after)) = (before, after) else {
            return self.outermost(place);
        };
        // The slopes on both sides if the pose is after the stage, and if it is before it.
        let slopes = |sign: f64| {
            let left = (before.1 - sign * least) / (place - before.0);
            let right = (after.1 + sign * least) / (after.0 - place);
            (left, right)
        };
        let misfit = |(left, right): (f64, f64)| match left > 0.0 && right > 0.0 {
            true => (left / right).ln().abs(),
            false => f64::INFINITY,
        };
        let [later, earlier] = [1.0, -1.0].map(slopes);
        let (sign, (left, right)) = match misfit(later) <= misfit(earlier) {
            true => (1.0, later),
            false => (-1.0, earlier),
        };
        place + sign * least / (left * right).sqrt()
    }

    /// The pose, as a fraction of the step, if it lies within the step.
    pub(crate) fn within(&self) -> Option<f64> {
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for &square in &self.inverse_squares {
            (least, most) = (least.min(square), most.max(square));
        }
        if !(least < FALLEN * most) {
            return None;
        }
        let pose = self.pose();
        (pose > 0.0 && pose < 1.0).then_some(pose)
    }

    /// The pose on the line through the two stages next to one at the end of the step.
    fn outermost(&self, place: f64) -> f64 {
        let mut apart = self
            .order
            .iter()
            .map(|&stage| self.seen(stage))
            .filter(|(other, _)| (other - place).abs() > APART);
        let pair = match place < 0.5 {
            true => apart.next().zip(apart.next()),
            false => apart.next_back().zip(apart.next_back()),
        };
        pair.map_or(f64::NAN, |(near, far)| {
            near.0 - near.1 * (far.0 - near.0) / (far.1 - near.1)
        })
    }

    /// The least distance of a stage from the pose for a step of this length, as a fraction of the largest; less if the next
    /// step begins shortly before the pose.
    fn clearance(&self, length: f64, pose: f64) -> f64 {
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for node in self.nodes {
            let distance = (pose - length * node).abs();
            (least, most) = (least.min(distance), most.max(distance));
        }
        let before = pose - length;
        if before > 0.0 && before < ROOM {
            least = least.min(LACK * before);
        }
        least / most
    }

    /// The clearance of a step of this length, as a fraction of the last one; NaN if the pose is not known.
    pub(crate) fn expected_clearance(&self, length: f64) -> f64 {
        let pose = self.pose();
        match pose.is_finite() {
            true => self.clearance(length, pose),
            false => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tableau::Tableau;
    use super::*;

    fn seen(pose: f64, sigma: impl Fn(f64) -> f64) -> StagePoses {
        let nodes = Tableau::of_order(8).expect("order 8").nodes;
        let mut poses = StagePoses::new(nodes);
        poses.begin();
        for (stage, node) in nodes.iter().enumerate() {
            poses.note(stage, 1.0 / sigma(node - pose).powi(2));
        }
        poses
    }

    #[test]
    fn the_pose_is_found() {
        for tenth in 1..12 {
            let pose = 0.1 * f64::from(tenth) - 0.013;
            let found = seen(pose, f64::abs).pose();
            assert!((found - pose).abs() < 1e-9, "{found} for {pose}");
            // σ grows less far away, and all stages are far from a pose after the step.
            let bent = seen(pose, |way| way.abs().tanh()).pose();
            let allowed = if pose < 1.0 { 0.02 } else { 0.03 };
            assert!((bent - pose).abs() < allowed, "{bent} for {pose}");
        }
    }

    #[test]
    fn a_pose_within_the_step_is_seen() {
        for hundredth in 1..100 {
            let pose = 0.01 * f64::from(hundredth);
            let within = seen(pose, f64::abs).within().expect("a pose");
            assert!((within - pose).abs() < 1e-9, "{within} for {pose}");
        }
        for pose in [-0.5, -0.1, 1.1, 1.5] {
            assert!(seen(pose, f64::abs).within().is_none(), "{pose}");
        }
        // Far from every pose, and beside one that is not nearly singular.
        assert!(seen(0.5, |way| 1.0 + way * way).within().is_none());
        assert!(seen(0.5, |way| 0.3 + 0.7 * way.abs()).within().is_none());
    }

    #[test]
    fn a_clearance_is_foreseen() {
        for hundredth in 1..150 {
            let pose = 0.01 * f64::from(hundredth);
            let poses = seen(pose, f64::abs);
            for length in [0.5, 0.8, 1.15] {
                // The next step has room before the pose, or begins after it.
                if pose > length && pose < length + 1.01 * ROOM {
                    continue;
                }
                let distances = || poses.nodes.iter().map(|node| (pose - length * node).abs());
                let least = distances().fold(f64::INFINITY, f64::min);
                let most = distances().fold(0.0, f64::max);
                assert!((poses.expected_clearance(length) - least / most).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn a_step_that_ended_early_tells_nothing() {
        let mut poses = seen(0.4, f64::abs);
        poses.begin();
        poses.note(0, 1.0);
        assert!(poses.expected_clearance(0.8).is_nan());
    }
}
