//! Held values that are stationary at the guess, as the height of an upright pendulum: no gradient leads from there to other
//! values, but a small step aside does.

use super::held::{HELD, Start};
use super::independence::independent_rows;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{dot, vector};
use crate::report::HeldGap;
use crate::{Level, System};
use nalgebra::SVector;

/// The step aside, in lengths of the mechanism and radians; of velocities as a part of those that are held.
pub(super) const ASIDE: f64 = 1e-3;
/// A derivative along free directions that is below this part of the whole one, or of 1, may be round-off.
const FLAT: f64 = 1e-6;
/// A value that changes by more than this many times what its derivative tells is stationary.
const CURVED: f64 = 100.0;
/// Changes below this part of what is missing are round-off.
const CONSTANT: f64 = 1e-10;
/// The part of a direction, of its length, that has to be independent of others, and of a velocity that has to be free.
const INDEPENDENT: f64 = 1e-3;

/// The held values around a guess.
pub(super) struct Vicinity<const N: usize> {
    /// A direction in which the stationary values change, a length of the mechanism or a radian long; `None` if no value is
    /// stationary.
    pub(super) aside: Option<SVector<f64, N>>,
    /// The values that do not change at all, by their places among those that are held.
    pub(super) constant: Vec<usize>,
}

impl<const N: usize> Vicinity<N> {
    /// Where no value is stationary.
    pub(super) fn regular() -> Self {
        Vicinity {
            aside: None,
            constant: Vec::new(),
        }
    }
}

/// What several searches have come to.
#[derive(Default)]
pub(super) struct Nearest {
    /// The values that are off in the end of a search where the largest gap is least.
    open: Option<Vec<HeldGap>>,
    fault: Option<Fault>,
}

impl Nearest {
    /// A search has ended with these values off.
    pub(super) fn ended(&mut self, open: Vec<HeldGap>) {
        // Where only rows are open, nothing is said about values.
        let largest = |open: &[HeldGap]| match open.is_empty() {
            true => f64::INFINITY,
            false => open
                .iter()
                .fold(0.0, |most: f64, held| most.max(held.gap.abs())),
        };
        match &self.open {
            Some(known) if !(largest(&open) < largest(known)) => {}
            _ => self.open = Some(open),
        }
    }

    /// A search could not go on.
    pub(super) fn failed(&mut self, fault: Fault) {
        self.fault.get_or_insert(fault);
    }

    /// The values that are off in the nearest start; the fault if every search had one.
    pub(super) fn open(self) -> Result<Vec<HeldGap>, Fault> {
        match (self.open, self.fault) {
            (None, Some(fault)) => Err(fault),
            (open, _) => Ok(open.unwrap_or_default()),
        }
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Start<'_, S, Q, N, R> {
    /// Which values that are off are stationary at (q, v). `gaps_at(way, factor)`: by how much all values are off `factor` times the way
    /// from there, on the rows; `None` where these cannot be satisfied. The steps aside have this `size`.
    ///
    /// Each stationary value has the first of the ways that change it by more than half of the most.
    pub(super) fn vicinity(
        &self,
        level: Level,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
        ways: &[SVector<f64, N>],
        size: f64,
        gaps_at: &mut dyn FnMut(&SVector<f64, N>, f64) -> Option<Vec<f64>>,
    ) -> Vicinity<N> {
        let (mut vicinity, whole) = (Vicinity::regular(), size / ASIDE);
        let gaps = self.gaps(level, q, v, &vec![1.0; self.count(level)]);
        let slopes: Vec<f64> = (self.of(level))
            .map(|condition| {
                let gradient = condition.gradient(self.system, q, v, self.yardstick);
                let along = ways.iter().map(|way| dot(&gradient, way).abs());
                let most = along.fold(0.0, f64::max);
                let own = self.own_length(condition);
                let whole = self.yardstick.row_length_squared(&gradient).sqrt().max(own);
                // A state has no direction among those of the motion, and any value.
                let is_of_state =
                    (0..N).any(|j| !self.yardstick.is_motion(j) && gradient[j] != 0.0);
                match most < FLAT * whole && !is_of_state {
                    true => most,
                    false => f64::INFINITY,
                }
            })
            .collect();
        let is_off = (self.of(level).zip(&gaps))
            .map(|(condition, gap)| gap.abs() > HELD * whole * self.own_length(condition))
            .collect::<Vec<_>>();
        let is_flat = |i: &usize| is_off[*i] && slopes[*i].is_finite();
        if ways.is_empty() || !(0..gaps.len()).any(|i| is_flat(&i)) {
            return vicinity;
        }
        let changes: Vec<Vec<f64>> = ways
            .iter()
            .map(|way| {
                let sides = [size, -size].map(|factor| gaps_at(way, factor));
                let change = |i: usize| {
                    let sides = sides.iter().flatten();
                    sides.fold(0.0, |most: f64, side| most.max((side[i] - gaps[i]).abs()))
                };
                (0..gaps.len()).map(change).collect()
            })
            .collect();
        let mut chosen = vec![false; ways.len()];
        for i in (0..gaps.len()).filter(is_flat) {
            let most = changes.iter().fold(0.0, |most: f64, way| most.max(way[i]));
            if most <= CONSTANT * gaps[i].abs() {
                vicinity.constant.push(i);
            } else if most > CURVED * size * slopes[i]
                && let Some(first) = changes.iter().position(|way| way[i] > 0.5 * most)
            {
                chosen[first] = true;
            }
        }
        let ways = ways.iter().zip(&chosen).filter(|(_, chosen)| **chosen);
        vicinity.aside = ways.map(|(way, _)| *way).reduce(|a, b| a + b);
        vicinity
    }

    /// Independent directions that the rows leave free, a length of the mechanism or a radian long: the velocities in their
    /// order, each in positive sense and projected in the metric of M.
    pub(super) fn free_ways(
        &self,
        level: Level,
        geometry: &ConstraintGeometry<S, Q, N, R>,
    ) -> Vec<SVector<f64, N>> {
        let yardstick = self.yardstick;
        let rows = match level {
            Level::Position => S::STRUCTURE.holonomic_rows,
            Level::Velocity => R,
        };
        let dependent = independent_rows(self.system, geometry, yardstick).dependent;
        // Rows a and M⁻¹a, orthonormal.
        let mut normal: Vec<[SVector<f64, N>; 2]> = Vec::new();
        for i in (0..rows).filter(|row| !dependent.contains(row)) {
            let [mut a, mut w] = [geometry.a.rows()[i], geometry.w.rows()[i]];
            // Twice, because of round-off.
            for _ in 0..2 {
                for [other, lifted] in &normal {
                    let part = dot(other, &w);
                    a -= other * part;
                    w -= lifted * part;
                }
            }
            let length = dot(&a, &w).max(0.0).sqrt();
            if length > 0.0 {
                normal.push([a / length, w / length]);
            }
        }
        let mut ways = Vec::new();
        let mut known: Vec<SVector<f64, N>> = Vec::new();
        for j in (0..N).filter(|&j| yardstick.is_motion(j)) {
            let unit = yardstick.displacement(vector(|i| if i == j { 1.0 } else { 0.0 }));
            let mut way = unit;
            for _ in 0..2 {
                for [a, w] in &normal {
                    way -= w * dot(a, &way);
                }
            }
            let length = yardstick.measure(&way);
            if !(length > INDEPENDENT) {
                continue;
            }
            way /= length;
            let mut rest = yardstick.sizes(&way);
            for other in &known {
                rest -= other * dot(other, &rest);
            }
            let length = dot(&rest, &rest).sqrt();
            if length > INDEPENDENT {
                known.push(rest / length);
                ways.push(way);
            }
        }
        ways
    }
}
