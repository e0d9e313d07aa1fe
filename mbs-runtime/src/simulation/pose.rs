//! Where σ, at the ends of steps, foresees a pose at which the rows lose their independence, or nearly do.
//!
//! ```text
//! σ² = k² (t − p)² + g²        t: time, p: that of the pose
//! ```
//!
//! with g = 0 at a singular pose.

use crate::LastStep;
use crate::singular::RankMargin;

/// σ at the ends of steps past a known singular pose, at least, for an embedded estimate to be believed, and of a pair of Radau.
pub(super) const FAR: f64 = 0.1;
/// A pose is looked for up to this multiple of a step away from its end: σ is not quite linear in time.
const AHEAD: f64 = 1.5;
/// The same multiple where σ is below this value: beside a pose that is nearly singular it falls more slowly.
pub(super) const NEAR_AHEAD: f64 = 6.0;
const NEAR: f64 = 0.02;

/// The lengths of the two steps of a pair, the rank margins at their ends, and a pose that stages have seen, s after the beginning.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passage {
    pub(super) steps: [f64; 2],
    pub(super) margins: [RankMargin; 3],
    pub(super) seen: Option<f64>,
}

impl LastStep {
    /// The rank margin where it began.
    pub(super) fn margin(&self) -> RankMargin {
        RankMargin {
            dependent: self.dependent,
            ..RankMargin::of(self.least)
        }
    }

    /// Whether σ, which is `before` and `now` at the ends of a step of h after this one, may foresee a pose: a quick
    /// test before [`Passage::poses_from_second`].
    #[inline(always)]
    pub(super) fn suspects(&self, h: f64, before: f64, now: f64) -> bool {
        let fallen = self.least - before;
        now < NEAR_AHEAD * (before - now) || before * self.length < AHEAD * fallen * h
    }
}

impl Passage {
    /// The time, s after the beginning of the pair, at which a straight σ comes to zero within the pair, or may do so, or stages
    /// have seen a pose. (In long steps σ is not straight.)
    #[inline]
    pub(super) fn pose(&self) -> Option<f64> {
        let seen = self.seen.filter(|_| self.has_same_rows());
        self.foreseen().or(seen)
    }

    /// The same by σ at the ends of the steps alone.
    #[inline]
    pub(super) fn foreseen(&self) -> Option<f64> {
        let ([first, second], [start, middle, end]) = (self.steps, self.margins);
        let falls = |from: f64, h: f64, ahead: f64| {
            middle.least * h < AHEAD * (from - middle.least) * ahead
        };
        let early = falls(end.least, second, first);
        let late = falls(start.least, first, second);
        (self.has_same_rows() && (early || late)).then(|| self.crossing(early, late))
    }

    /// Whether no singular pose is in or near the pair.
    pub(super) fn is_far_from_poses(&self) -> bool {
        let is_far = |margin: &RankMargin| margin.least > FAR;
        self.has_same_rows() && self.pose().is_none() && self.margins.iter().all(is_far)
    }

    /// Whether as many rows are dependent at all three instants: of other rows σ cannot be compared.
    #[inline]
    pub(super) fn has_same_rows(&self) -> bool {
        let [start, middle, end] = self.margins.map(|margin| margin.dependent);
        start == middle && end == middle
    }

    /// The same in the second step, or in one after the pair: what is likelier first.
    #[inline]
    pub(super) fn poses_from_second(&self) -> [Option<f64>; 2] {
        let ([first, second], [start, middle, end]) = (self.steps, self.margins);
        let within = self.pose().filter(|&pose| pose > first);
        let ahead = if end.least < NEAR { NEAR_AHEAD } else { AHEAD };
        let falls = end.least < ahead * (middle.least - end.least);
        if !falls || end.dependent != middle.dependent {
            return [within, None];
        }
        let before = (start.least - middle.least) / first;
        let crosses = unlike(before, (middle.least + end.least) / second)
            < unlike(before, (middle.least - end.least) / second);
        let beyond = first + second + second * end.least / (middle.least - end.least);
        match crosses {
            true => [within, Some(beyond)],
            false => [Some(beyond), within],
        }
    }

    /// The same in the first step (`early`) or the second.
    #[cold]
    fn crossing(&self, early: bool, late: bool) -> f64 {
        let ([first, second], margins) = (self.steps, self.margins);
        let [start, middle, end] = margins.map(|margin| margin.least);
        // If σ changes its sign in one of the two steps, its rates in them are alike.
        let first_is_like = || {
            unlike((start + middle) / first, (end - middle) / second)
                < unlike((start - middle) / first, (middle + end) / second)
        };
        match early && (!late || first_is_like()) {
            true => first * start / (start + middle),
            false => first + second * middle / (middle + end),
        }
    }
}

/// How much two rates of σ differ.
fn unlike(a: f64, b: f64) -> f64 {
    (a - b).abs() / (a + b)
}

/// σ² at a time, s after the beginning of the pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Probe {
    pub(super) time: f64,
    pub(super) square: f64,
}

impl Probe {
    pub(super) fn new(time: f64, margin: RankMargin) -> Self {
        Probe {
            time,
            square: margin.least.powi(2),
        }
    }

    /// The least σ² first. (Outside of generic functions: a sort is thousands of lines to compile.)
    pub(super) fn sort(probes: &mut [Probe]) {
        probes.sort_unstable_by(|a, b| a.square.total_cmp(&b.square));
    }
}

/// The minimum of a parabola through three probes.
pub(super) struct Minimum {
    /// From the first of them, s.
    pub(super) way: f64,
    /// σ² there.
    pub(super) square: f64,
    /// k.
    pub(super) rate: f64,
}

/// The minimum of the parabola through three probes; `None` if it has none.
pub(super) fn minimum([a, b, c]: [Probe; 3]) -> Option<Minimum> {
    let slope = |to: Probe| (to.square - a.square) / (to.time - a.time);
    let curvature = (slope(c) - slope(b)) / (c.time - b.time);
    let slope = slope(b) - curvature * (b.time - a.time);
    let way = -0.5 * slope / curvature;
    (curvature > 0.0 && way.is_finite()).then(|| Minimum {
        way,
        square: a.square + 0.5 * slope * way,
        rate: curvature.sqrt(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn passage(sigma: [f64; 3]) -> Passage {
        Passage {
            steps: [1.0, 1.0],
            margins: sigma.map(RankMargin::of),
            seen: None,
        }
    }

    #[test]
    fn poses_in_a_pair_are_found() {
        for pose in [0.1, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9] {
            let sigma = [0.0, 1.0, 2.0].map(|time: f64| 0.1 * (time - pose).abs());
            let found = passage(sigma).pose().unwrap();
            assert!((found - pose).abs() < 1e-12, "{found} for {pose}");
        }
        for sigma in [[1.0; 3], [0.5, 0.4, 0.3], [0.3, 0.4, 0.5], [0.1, 0.2, 0.1]] {
            assert!(passage(sigma).pose().is_none(), "{sigma:?}");
        }
    }

    #[test]
    fn the_least_margin_is_foreseen() {
        let probe = |time: f64| Probe {
            time,
            square: 4.0 * (time - 0.3).powi(2) + 0.01,
        };
        let found = minimum([0.2, 0.5, 1.0].map(probe)).unwrap();
        assert!((found.way - 0.1).abs() < 1e-12 && (found.square - 0.01).abs() < 1e-12);
        assert!((found.rate - 2.0).abs() < 1e-12);
        let level = |time| Probe { time, square: 1.0 };
        assert!(minimum([0.2, 0.5, 1.0].map(level)).is_none());
    }
}
