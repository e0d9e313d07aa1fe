//! Detection of singular poses during the motion, from the rank margins at the ends of steps.

use super::Simulation;
use crate::linear::{array, largest_of};
use crate::memory::cloned_with_room;
use crate::singular::{OTHER_ROWS, RankMargin};
use crate::{RankLoss, System};

/// σ_min below which a pose counts as singular.
const SINGULAR: f64 = 0.02;
/// The factor by which σ_min has to be larger before and after, because in some mechanisms σ_min is always small.
const PROMINENT: f64 = 10.0;
/// σ_min above which changes are larger than noise.
const NOISE: f64 = 1e-3;
/// Change of the slope of σ, relative to it, up to which it counts as straight.
const STRAIGHT: f64 = 0.2;
/// A row takes part in a loss with at least this part of the largest weight.
const INVOLVED: f64 = 0.1;
/// Losses that are kept, those of the last poses: a step does not allocate, and a run may last for weeks.
const KEPT: usize = 64;

/// The end of a step: time, and σ_min of the rows that are not always redundant.
#[derive(Debug, Clone, Copy)]
struct Instant {
    time: f64,
    sigma: f64,
}

/// Before any step.
const NOWHERE: Instant = Instant {
    time: f64::NEG_INFINITY,
    sigma: f64::INFINITY,
};

/// A pose with a small σ_min.
#[derive(Debug, Clone, Copy)]
struct Found {
    time: f64,
    sigma: f64,
    /// The end of the step that it was seen from.
    seen: f64,
}

/// The last instants, and what was found before.
#[derive(Debug, Clone)]
pub(super) struct SingularityDetector {
    /// Latest last.
    instants: [Instant; 3],
    /// Whether σ_min fell in the last step.
    falling: bool,
    /// The number of rows that were dependent in all poses so far.
    redundant: u32,
    /// The largest σ_min since the last loss.
    peak: f64,
    /// A pose that will be a loss when σ_min has risen above `level`; infinite when there is none.
    level: f64,
    pending: Found,
    /// When the last loss was reported: steps may be taken again from before.
    reported: f64,
    /// The start, s, of a mechanism that is at rest there, until it has left a singular pose.
    rest: Option<f64>,
    /// Whether rows that were lost from the start on have come back.
    came_back: bool,
    losses: Losses,
}

/// What was reported so far.
#[derive(Debug)]
struct Losses {
    last: Vec<RankLoss>,
    count: usize,
}

impl Losses {
    fn none() -> Self {
        Losses {
            last: Vec::with_capacity(KEPT),
            count: 0,
        }
    }

    fn push(&mut self, loss: RankLoss) {
        if self.last.len() == KEPT {
            self.last.remove(0);
        }
        self.last.push(loss);
        self.count += 1;
    }
}

impl Clone for Losses {
    /// With the same room, so that steps of a copy do not allocate either.
    fn clone(&self) -> Self {
        Losses {
            last: cloned_with_room(&self.last),
            count: self.count,
        }
    }
}

impl SingularityDetector {
    /// `rest` is the start, s, if the mechanism is at rest there.
    pub(super) fn new(rest: Option<f64>) -> Self {
        SingularityDetector {
            instants: [NOWHERE; 3],
            falling: true,
            redundant: OTHER_ROWS - 1,
            peak: f64::INFINITY,
            level: f64::INFINITY,
            pending: Found {
                time: f64::NEG_INFINITY,
                sigma: f64::INFINITY,
                seen: f64::NEG_INFINITY,
            },
            reported: f64::NEG_INFINITY,
            rest,
            came_back: false,
            losses: Losses::none(),
        }
    }

    /// Begins with the losses of a detector before it.
    pub(super) fn take_over(&mut self, before: &Self) {
        let own = std::mem::replace(&mut self.losses, before.losses.clone());
        for loss in own.last {
            self.losses.push(loss);
        }
    }

    /// Those of the last poses.
    pub(super) fn losses(&self) -> &[RankLoss] {
        &self.losses.last
    }

    /// The number of all.
    pub(super) fn count(&self) -> usize {
        self.losses.count
    }

    /// Takes note of the end of a step; time and σ_min of a singular pose that has just been passed.
    #[inline]
    fn note(&mut self, time: f64, now: RankMargin) -> Option<(f64, f64)> {
        let mut sigma = now.least;
        if now.dependent != self.redundant || time <= self.instants[2].time {
            sigma = self.reconsider(time, now);
        }
        if self.falling && sigma > self.instants[2].sigma {
            self.turned(Instant { time, sigma });
        }
        let found = if sigma > self.level {
            self.leave(Instant { time, sigma })
        } else {
            None
        };
        self.falling = sigma <= self.instants[2].sigma;
        self.peak = self.peak.max(sigma);
        self.instants = [self.instants[1], self.instants[2], Instant { time, sigma }];
        found
    }

    /// σ_min where it is not simply that of the rows: when rows were lost or came back, or a step was taken again.
    #[cold]
    fn reconsider(&mut self, time: f64, now: RankMargin) -> f64 {
        if now.is_of_others(self.redundant) {
            (self.instants, self.falling) = ([NOWHERE; 3], true);
            self.level = f64::INFINITY;
            self.redundant ^= OTHER_ROWS;
        }
        while time <= self.instants[2].time {
            self.instants = [NOWHERE, self.instants[0], self.instants[1]];
            self.falling = self.instants[2].sigma <= self.instants[1].sigma;
        }
        if self.pending.seen >= time {
            self.level = f64::INFINITY;
        }
        if now.dependent > self.redundant {
            return 0.0;
        }
        if now.dependent < self.redundant {
            // The row was not redundant: the start was a singular pose.
            let known = self.instants.iter_mut().filter(|i| i.time.is_finite());
            known.for_each(|instant| instant.sigma = 0.0);
            // What σ of the other rows did until now does not count.
            self.falling = true;
            self.came_back = true;
            self.redundant = now.dependent;
        }
        now.least
    }

    /// The pose that was pending is a loss.
    #[cold]
    fn leave(&mut self, now: Instant) -> Option<(f64, f64)> {
        (self.peak, self.level) = (now.sigma, f64::INFINITY);
        self.reported = now.time;
        Some((self.pending.time, self.pending.sigma))
    }

    /// Takes note that the motion has left the pose of this time; whether it began there at rest.
    fn leaves_rest(&mut self, time: f64) -> bool {
        let rest = self.rest.take();
        rest.is_some_and(|start| self.came_back || time == start)
    }

    /// Keeps the minimum about the last instant, if it is small.
    #[cold]
    fn turned(&mut self, after: Instant) {
        let seen = self.instants[2].time;
        let Some((time, sigma)) = self.minimum(after) else {
            return;
        };
        let lower = self.level == f64::INFINITY || sigma < self.pending.sigma;
        if self.peak > PROMINENT * sigma && seen > self.reported && lower {
            self.pending = Found { time, sigma, seen };
            self.level = (PROMINENT * sigma).max(NOISE);
        }
    }

    /// The minimum about the last instant.
    fn minimum(&self, after: Instant) -> Option<(f64, f64)> {
        let [_, before, middle] = self.instants;
        let (mut time, mut square) = (middle.time, middle.sigma * middle.sigma);
        if before.time.is_finite() {
            // σ² is smooth, where σ has a corner: the parabola through three points.
            let slope = |a: Instant, b: Instant| {
                (b.sigma - a.sigma) * (b.sigma + a.sigma) / (b.time - a.time)
            };
            let (fall, rise) = (slope(before, middle), slope(middle, after));
            let curvature = (rise - fall) / (after.time - before.time);
            let slope = fall + curvature * (middle.time - before.time);
            if curvature > 0.0 && curvature.is_finite() {
                let way = (-0.5 * slope / curvature)
                    .clamp(before.time - middle.time, after.time - middle.time);
                time += way;
                square = (square + way * (slope + curvature * way)).max(0.0);
            }
        }
        if square < SINGULAR * SINGULAR {
            return Some((time, square.sqrt()));
        }
        // Long steps.
        crossing(before, middle, after).map(|time| (time, 0.0))
    }
}

/// The zero of σ, if σ with its sign changed after the pose is linear in time.
fn crossing(before: Instant, middle: Instant, after: Instant) -> Option<f64> {
    let slope = |a: Instant, b: Instant| (b.sigma - a.sigma) / (b.time - a.time);
    let behind = |instant: Instant| Instant {
        sigma: -instant.sigma,
        ..instant
    };
    let ways = [
        [before, middle, behind(after)],
        [before, behind(middle), behind(after)],
    ];
    ways.into_iter().enumerate().find_map(|(first, [a, b, c])| {
        let (fall, rise) = (slope(a, b), slope(b, c));
        let straight = (fall - rise).abs() < STRAIGHT * (fall + rise).abs();
        let start = if first == 0 { b } else { a };
        let rate = if first == 0 { rise } else { fall };
        straight.then(|| start.time - start.sigma / rate)
    })
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Looks for a singular pose after each step.
    #[inline]
    pub(super) fn watch(&mut self) {
        if let Some(now) = self.rank_margin
            && let Some((time, sigma)) = self.singularities.note(self.time(), now)
        {
            self.note_loss(time, sigma);
        }
    }

    #[cold]
    #[inline(never)]
    fn note_loss(&mut self, time: f64, sigma: f64) {
        let mut weights = self.integrator.weakest_rows();
        let mut order: [usize; R] = array(|i| i);
        let involved = strongest(weights.as_mut_slice(), &mut order);
        let involved = involved
            .iter()
            .filter_map(|&i| Some(S::MODEL.rows.get(i)?.entry));
        let undetermined = self.singularities.leaves_rest(time);
        let loss = RankLoss::new(time, sigma, undetermined, involved);
        self.singularities.losses.push(loss);
    }
}

/// The part of `order` with the weights that are not small, the largest first. (Not generic: compiled once.)
fn strongest<'a>(weights: &mut [f64], order: &'a mut [usize]) -> &'a [usize] {
    for weight in weights.iter_mut() {
        *weight = weight.abs();
    }
    let most = largest_of(weights);
    order.sort_unstable_by(|&i, &j| weights[j].total_cmp(&weights[i]));
    let involved = |&i: &usize| weights[i] >= INVOLVED * most && most > 0.0;
    let count = order.iter().take_while(|i| involved(i)).count();
    &order[..count]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noted(
        singularities: &mut SingularityDetector,
        step: f64,
        sigma: impl Fn(f64) -> f64,
    ) -> Vec<(f64, f64)> {
        (0..200)
            .filter_map(|i| {
                let time = f64::from(i) * step;
                singularities.note(time, RankMargin::of(sigma(time)))
            })
            .collect()
    }

    #[test]
    fn poses_between_steps_are_found() {
        let found = noted(&mut SingularityDetector::new(None), 0.05, |t| {
            (t - 1.0 / 3.0).sin().abs()
        });
        let expected = [1.0, 2.0, 3.0].map(|turn| 1.0 / 3.0 + turn * std::f64::consts::PI);
        assert_eq!(found.len(), 4, "{found:?}");
        for (found, expected) in found[1..].iter().zip(expected) {
            assert!(
                (found.0 - expected).abs() < 1e-3 && found.1 < 1e-2,
                "{found:?}"
            );
        }
    }

    #[test]
    fn weak_poses_and_rest_are_no_passages() {
        let weak = |t: f64| 0.05_f64.hypot((t - 0.3).sin());
        assert!(noted(&mut SingularityDetector::new(None), 0.05, weak).is_empty());
        // At rest in a singular pose, with noise.
        let rest = |t: f64| 1e-9 * (1.0 + (1e3 * t).sin());
        assert!(noted(&mut SingularityDetector::new(None), 0.05, rest).is_empty());
        // σ is always small, and has no minimum.
        let small = |t: f64| 4e-3 + 2e-3 * t.sin();
        assert!(noted(&mut SingularityDetector::new(None), 0.05, small).is_empty());
    }

    #[test]
    fn a_start_in_a_singular_pose_counts() {
        let found = noted(&mut SingularityDetector::new(None), 0.01, |t| 0.2 * t);
        assert_eq!(found, [(0.0, 0.0)]);
    }

    /// Rows are lost for some steps, in which σ of the others rises.
    #[test]
    fn a_slow_start_in_a_singular_pose_counts() {
        let mut singularities = SingularityDetector::new(None);
        let mut found = Vec::new();
        for i in 0..20 {
            let time = 0.01 * f64::from(i);
            let lost = RankMargin {
                dependent: 1,
                ..RankMargin::of(0.5 + 1e-3 * time)
            };
            let now = if i < 3 {
                lost
            } else {
                RankMargin::of(0.2 * time)
            };
            found.extend(singularities.note(time, now));
        }
        assert!(
            matches!(found[..], [(time, 0.0)] if time < 0.03),
            "{found:?}"
        );
    }
}
