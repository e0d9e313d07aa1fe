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
//! parabola tell which. They are taken only where σ of the pair itself has a minimum that may be small.

use super::Simulation;
use crate::singular::RankMargin;
use crate::{SimulationError, System};

/// A pose is looked for up to this multiple of a step away from its end: σ is not quite linear in time.
const AHEAD: f64 = 1.5;
/// The least σ of a pose that is not singular, as a multiple of √e for an error e of the position rows, as a
/// displacement: it shifts a row that is quadratic in the distance from the pose by √e.
const SINGULAR: f64 = 30.0;
/// A pair may begin or end at this multiple of the least σ between. With a larger value a pair may pass the pose as if
/// the branches met; a smaller one takes shorter steps there.
const LEAP: f64 = 8.0;
/// Probes of a pair, at most: two are usual at a singular pose. (Probes of one stage instead of a step were tried: they
/// end too far from the motion, and one run in ninety of `tests/near_singular.rs` took the wrong branch.)
const PROBES: usize = 8;
/// The minimum of the parabola is no other than the least probe if σ² there is more than this fraction.
const FOUND: f64 = 0.5;

/// The lengths of the two steps of a pair, and the rank margins at their ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passage {
    pub(super) steps: [f64; 2],
    pub(super) margins: [RankMargin; 3],
}

impl Passage {
    /// The time, s after the beginning of the pair, at which a straight σ comes to zero within the pair, or may do so.
    #[inline]
    pub(super) fn pose(&self) -> Option<f64> {
        let ([first, second], [start, middle, end]) = (self.steps, self.margins);
        let falls = |from: f64, h: f64, ahead: f64| {
            middle.least * h < AHEAD * (from - middle.least) * ahead
        };
        let early = falls(end.least, second, first);
        let late = falls(start.least, first, second);
        // Of other rows σ cannot be compared.
        let same = start.dependent == middle.dependent && end.dependent == middle.dependent;
        (same && (early || late)).then(|| self.crossing(early, late))
    }

    /// The same in the first step (`early`) or the second.
    #[cold]
    fn crossing(&self, early: bool, late: bool) -> f64 {
        let ([first, second], margins) = (self.steps, self.margins);
        let [start, middle, end] = margins.map(|margin| margin.least);
        // How much the rates of σ in the two steps differ if it changes its sign in one of them.
        let unlike = |a: f64, b: f64| (a - b).abs() / (a + b);
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

/// σ² at a time, s after the beginning of the pair.
#[derive(Debug, Clone, Copy)]
struct Probe {
    time: f64,
    square: f64,
}

impl Probe {
    fn new(time: f64, margin: RankMargin) -> Self {
        Probe {
            time,
            square: margin.least.powi(2),
        }
    }
}

/// The way from the first of three probes to the minimum of the parabola through them, and its value there; `None` if it
/// has none.
fn minimum([a, b, c]: [Probe; 3]) -> Option<(f64, f64)> {
    let slope = |to: Probe| (to.square - a.square) / (to.time - a.time);
    let curvature = (slope(c) - slope(b)) / (c.time - b.time);
    let slope = slope(b) - curvature * (b.time - a.time);
    let way = -0.5 * slope / curvature;
    (curvature > 0.0 && way.is_finite()).then_some((way, a.square + 0.5 * slope * way))
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Whether the pair of steps that has just been taken passes a pose that is nearly singular as if it were singular.
    #[inline]
    pub(super) fn leaps(&mut self, passage: &Passage) -> Result<bool, SimulationError> {
        match passage.pose() {
            Some(pose) => self.look_between(passage, pose),
            None => Ok(false),
        }
    }

    #[cold]
    #[inline(never)]
    fn look_between(&mut self, passage: &Passage, pose: f64) -> Result<bool, SimulationError> {
        let kept = (self.report, self.power, self.rank_margin);
        let least = self.least_between(passage, pose);
        self.integrator.state_mut().copy_from(&self.before);
        (self.report, self.power, self.rank_margin) = kept;
        self.integrator.refresh(&self.settings)?;
        let [start, _, end] = passage.margins;
        Ok(start.least.max(end.least) > LEAP * least?)
    }

    /// The least σ between the ends of the pair, about `pose`; infinite if there is no minimum, or if the pose is
    /// singular.
    fn least_between(&mut self, passage: &Passage, pose: f64) -> Result<f64, SimulationError> {
        let exact = (self.yardstick).round_off_of_positions(&self.before.positions);
        let singular = SINGULAR * self.settings.constraint_tolerance.max(exact).sqrt();
        let [first, second] = passage.steps;
        let length = first + second;
        let [start, middle, end] = passage.margins;
        let mut probes = [
            Probe::new(0.0, start),
            Probe::new(first, middle),
            Probe::new(length, end),
        ];
        let (mut time, mut seen) = (pose, 0);
        for _ in 0..PROBES {
            probes.sort_unstable_by(|a, b| a.square.total_cmp(&b.square));
            let Some(margin) = self.probe(time)? else {
                // A step that ends there does not converge.
                time = 0.5 * (time + probes[0].time);
                continue;
            };
            if margin.dependent != middle.dependent || margin.least <= singular {
                return Ok(f64::INFINITY);
            }
            seen += 1;
            probes[2] = Probe::new(time, margin);
            probes.sort_unstable_by(|a, b| a.square.total_cmp(&b.square));
            let Some((way, foreseen)) = minimum(probes) else {
                break;
            };
            // The first parabola may be through points that are far from the pose.
            let found = seen > 1 && foreseen > FOUND * probes[0].square;
            time = probes[0].time + way;
            if found || !(time > 0.0 && time < length) {
                break;
            }
        }
        let Probe { time, square } = probes[0];
        let inside = seen > 0 && time > 0.0 && time < length;
        Ok(if inside { square.sqrt() } else { f64::INFINITY })
    }

    /// The rank margin at a time of the pair, s after its beginning; `None` if no step leads there.
    fn probe(&mut self, time: f64) -> Result<Option<RankMargin>, SimulationError> {
        self.integrator.state_mut().copy_from(&self.pair);
        self.rank_margin = None;
        self.integrator.refresh(&self.settings)?;
        match self.advance(time) {
            Ok(_) => Ok(Some(self.margin())),
            Err(error) if error.asks_for_less() => Ok(None),
            Err(SimulationError::NonFinite { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn passage(sigma: [f64; 3]) -> Passage {
        Passage {
            steps: [1.0, 1.0],
            margins: sigma.map(RankMargin::of),
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
        let (way, foreseen) = minimum([0.2, 0.5, 1.0].map(probe)).unwrap();
        assert!((way - 0.1).abs() < 1e-12 && (foreseen - 0.01).abs() < 1e-12);
        let level = |time| Probe { time, square: 1.0 };
        assert!(minimum([0.2, 0.5, 1.0].map(level)).is_none());
    }
}
