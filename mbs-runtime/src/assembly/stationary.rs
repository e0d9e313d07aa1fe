//! Held values that are stationary at the guess, as the height of an upright pendulum: no gradient leads from there to other
//! values, but a step aside does.

use super::held::{HELD, Start};
use super::independence::independent_rows;
use super::newton::ASSEMBLED;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{dot, vector};
use crate::report::HeldGap;
use crate::{Level, System};
use nalgebra::SVector;

/// The step aside, in lengths of the mechanism and radians; of velocities as a part of those that are held.
pub(super) const ASIDE: f64 = 1e-3;
/// A longer one, for values that hardly change by the first, as a fourth power. With a still longer one rows would be closed less
/// exactly.
pub(super) const FARTHER_ASIDE: f64 = 3e-2;
/// A derivative along free directions that is below this part of the whole one, or of 1, may be round-off.
const FLAT: f64 = 1e-6;
/// A value that changes by more than this many times what its derivative tells is stationary.
const CURVED: f64 = 100.0;
/// Changes below this part of what is missing are round-off.
const CONSTANT: f64 = 1e-10;
/// Changes of positions below this may be what rows leave open: for them no way is preferred to others.
const OPEN: f64 = 10.0 * ASSEMBLED;
/// The part of a direction, of its length, that has to be independent of others, and of a velocity that has to be free.
const INDEPENDENT: f64 = 1e-3;

/// Directions for steps aside.
pub(super) struct Ways<const N: usize> {
    /// Those that change no regular value, and then all that the rows leave free.
    choices: [Vec<SVector<f64, N>>; 2],
    /// The largest derivative of each held value along them; infinite of a regular one.
    slopes: Vec<f64>,
}

/// The held values around a guess.
pub(super) struct Vicinity<const N: usize> {
    /// A step that changes the stationary values; `None` if no value is stationary.
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
    /// from there, on the rows; `None` where these cannot be satisfied. The steps aside have the first of these `sizes` that changes
    /// the value; `whole` is the size of what is held.
    ///
    /// Each stationary value has the first of the ways that change it by more than half of the most. Ways along which regular values
    /// stay come first: these would have to move back on the only way of the other one.
    pub(super) fn vicinity(
        &self,
        level: Level,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
        Ways { choices, slopes }: &Ways<N>,
        (whole, sizes): (f64, &[f64]),
        gaps_at: &mut dyn FnMut(&SVector<f64, N>, f64) -> Option<Vec<f64>>,
    ) -> Vicinity<N> {
        let mut vicinity = Vicinity::regular();
        let gaps = self.gaps(level, q, v, &vec![1.0; self.count(level)]);
        let is_off = (self.of(level).zip(&gaps))
            .map(|(condition, gap)| gap.abs() > HELD * whole * self.own_length(condition))
            .collect::<Vec<_>>();
        let is_flat = |i: &usize| is_off[*i] && slopes[*i].is_finite();
        let mut still: Vec<usize> = (0..gaps.len()).filter(is_flat).collect();
        if choices[1].is_empty() || still.is_empty() {
            return vicinity;
        }
        let mut steps: Vec<SVector<f64, N>> = Vec::new();
        let least = (self.of(level).zip(&gaps))
            .map(|(condition, gap)| (CONSTANT * gap.abs(), OPEN * self.own_length(condition)))
            .collect::<Vec<_>>();
        let tries = choices.iter().zip([true, false]).flat_map(|choice| {
            let sizes = sizes.iter();
            sizes.map(move |&size| (choice, size))
        });
        for ((ways, is_beside), size) in tries {
            if still.is_empty() {
                break;
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
            still.retain(|&i| {
                let most = changes.iter().fold(0.0, |most: f64, way| most.max(way[i]));
                let (constant, open) = least[i];
                let may_be_open = is_beside && level == Level::Position && most <= open;
                if most <= constant || may_be_open {
                    return true;
                }
                if most > CURVED * size * slopes[i]
                    && let Some(first) = changes.iter().position(|way| way[i] > 0.5 * most)
                {
                    let step = ways[first] * size;
                    if !steps.contains(&step) {
                        steps.push(step);
                    }
                }
                false
            });
        }
        vicinity.constant = still;
        vicinity.aside = steps.into_iter().reduce(|a, b| a + b);
        vicinity
    }

    /// The directions for steps aside from (q, v), where the geometry is evaluated.
    pub(super) fn ways(
        &self,
        level: Level,
        geometry: &ConstraintGeometry<S, Q, N, R>,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
    ) -> Ways<N> {
        let all = self.free_ways(level, geometry, &[]);
        let (mut slopes, mut regular) = (Vec::new(), Vec::new());
        for condition in self.of(level) {
            let gradient = condition.gradient(self.system, q, v, self.yardstick);
            let along = all.iter().map(|way| dot(&gradient, way).abs());
            let most = along.fold(0.0, f64::max);
            let own = self.own_length(condition);
            let whole = self.yardstick.row_length_squared(&gradient).sqrt().max(own);
            // A state may have any value.
            let is_of_state = (0..N).any(|j| !self.yardstick.is_motion(j) && gradient[j] != 0.0);
            let is_flat = most < FLAT * whole && !is_of_state;
            slopes.push(if is_flat { most } else { f64::INFINITY });
            if !is_flat {
                regular.push(gradient);
            }
        }
        let beside = match regular.len() == slopes.len() || regular.is_empty() {
            true => Vec::new(),
            false => self.free_ways(level, geometry, &regular),
        };
        Ways {
            choices: [beside, all],
            slopes,
        }
    }

    /// Independent directions that the rows leave free, and along which the values with these gradients stay. Each is a length of the
    /// mechanism, a radian or a unit of a state long. They are the velocities in their order, each in positive sense and projected in
    /// the metric of M.
    fn free_ways(
        &self,
        level: Level,
        geometry: &ConstraintGeometry<S, Q, N, R>,
        gradients: &[SVector<f64, N>],
    ) -> Vec<SVector<f64, N>> {
        let yardstick = self.yardstick;
        let rows = match level {
            Level::Position => S::STRUCTURE.holonomic_rows,
            Level::Velocity => R,
        };
        let dependent = independent_rows(self.system, geometry, yardstick).dependent;
        // Rows a and M⁻¹a, orthonormal.
        let mut normal: Vec<[SVector<f64, N>; 2]> = Vec::new();
        let of_rows = (0..rows).filter(|row| !dependent.contains(row));
        let of_rows = of_rows.map(|i| [geometry.a.rows()[i], geometry.w.rows()[i]]);
        let of_values = gradients.iter().map(|gradient| {
            let mut lifted = *gradient;
            self.system.solve_mass(&geometry.mass, &mut lifted);
            [*gradient, lifted]
        });
        let of_rows = of_rows.map(|row| (row, 0.0));
        // Values may depend on each other.
        let of_values = of_values.map(|row| (row, FLAT * dot(&row[0], &row[1]).max(0.0).sqrt()));
        for ([mut a, mut w], least) in of_rows.chain(of_values) {
            // Twice, because of round-off.
            for _ in 0..2 {
                for [other, lifted] in &normal {
                    let part = dot(other, &w);
                    a -= other * part;
                    w -= lifted * part;
                }
            }
            let length = dot(&a, &w).max(0.0).sqrt();
            if length > least {
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
        // Rows leave states free, which are among the velocities.
        if level == Level::Velocity {
            let of_states = (0..N).filter(|&j| !yardstick.is_motion(j));
            ways.extend(of_states.map(|j| vector(|i| if i == j { 1.0 } else { 0.0 })));
        }
        ways
    }
}
