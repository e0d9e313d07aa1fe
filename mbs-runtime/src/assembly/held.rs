//! A start that holds values: they are equations beside the rows.

use super::closing::{Equations, Linearised, norm, solve};
use super::conditions::Condition;
use super::newton::{ASSEMBLED, close};
use super::stationary::{ASIDE, FARTHER_ASIDE, Nearest, Vicinity};
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{entries, vector};
use crate::report::HeldGap;
use crate::row_scale::RowScale;
use crate::yardstick::Yardstick;
use crate::{Level, SimulationError, System};
use nalgebra::SVector;

/// The largest part of a length or radian by which held values move while the rows follow.
const STRIDE: f64 = 0.25;
/// The most of these parts.
const MOST_STRIDES: f64 = 200.0;
/// The longest Newton step, in lengths of the mechanism and radians: near a pose where a value is stationary a small change of it has
/// a way of many turns.
const LONGEST_STEP: f64 = 0.5;
/// A held value that differs by less, in lengths of the mechanism and radians, is held.
pub(super) const HELD: f64 = 1e-11;

/// What the equations of a start consist of.
pub(super) struct Start<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(super) system: &'a S,
    pub(super) conditions: &'a [Condition],
    pub(super) scale: &'a RowScale<R>,
    pub(super) yardstick: &'a Yardstick<Q, N>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Start<'_, S, Q, N, R> {
    pub(super) fn of(&self, level: Level) -> impl Iterator<Item = &Condition> + Clone {
        let conditions = self.conditions.iter();
        conditions.filter(move |condition| condition.level == level)
    }

    /// How many values are held.
    pub(super) fn count(&self, level: Level) -> usize {
        self.of(level).count()
    }

    /// A pose that satisfies the rows and holds the positions, or what is off in the nearest one. Where a value is stationary at the
    /// guess, its positive side is tried first, then the negative one, and then the guess itself ([`Self::vicinity`]).
    pub(super) fn place(
        &self,
        geometry: &mut ConstraintGeometry<S, Q, N, R>,
        guess: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<Result<SVector<f64, Q>, Vec<HeldGap>>, Fault> {
        let Start { system, scale, .. } = *self;
        let (mut q, mut phi) = (*guess, SVector::zeros());
        geometry.evaluate(system, 0.0, &q, &mut phi)?;
        let closed = close(system, 0.0, geometry, &mut q, &mut phi, scale);
        let vicinity = match closed.is_ok() && scale.displacement(&phi) <= ASSEMBLED {
            true => self.poses_around(geometry, (&q, v)),
            false => Vicinity::regular(),
        };
        if !vicinity.constant.is_empty() {
            return Ok(Err(self.open(Level::Position, (&q, v), 1.0, &vicinity)));
        }
        let begin = match &vicinity.aside {
            None => vec![*guess],
            Some(way) => {
                let [one, other] = [1.0, -1.0].map(|factor| system.advance(&q, way, factor));
                vec![one, other, *guess]
            }
        };
        let mut nearest = Nearest::default();
        for mut q in begin {
            if let Err(fault) = self.positions(geometry, &mut q, v) {
                nearest.failed(fault);
                continue;
            }
            let open = self.open(Level::Position, (&q, v), 1.0, &vicinity);
            system.holonomic(0.0, &q, &mut phi);
            if open.is_empty() && scale.displacement(&phi) <= ASSEMBLED {
                return Ok(Ok(q));
            }
            nearest.ended(open);
        }
        nearest.open().map(Err)
    }

    /// The held positions around a pose, which the geometry belongs to before.
    fn poses_around(
        &self,
        geometry: &mut ConstraintGeometry<S, Q, N, R>,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
    ) -> Vicinity<N> {
        let Start { system, scale, .. } = *self;
        let ways = self.ways(Level::Position, geometry, (q, v));
        let unscaled = vec![1.0; self.count(Level::Position)];
        let sizes = (1.0, &[ASIDE, FARTHER_ASIDE][..]);
        self.vicinity(Level::Position, (q, v), &ways, sizes, &mut |way, factor| {
            let (mut q, mut phi) = (system.advance(q, way, factor), SVector::zeros());
            geometry.evaluate(system, 0.0, &q, &mut phi).ok()?;
            close(system, 0.0, geometry, &mut q, &mut phi, scale).ok()?;
            let is_closed = scale.displacement(&phi) <= ASSEMBLED;
            is_closed.then(|| self.gaps(Level::Position, &q, v, &unscaled))
        })
    }

    /// The held velocities around v.
    pub(super) fn velocities_around(
        &self,
        geometry: &ConstraintGeometry<S, Q, N, R>,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
    ) -> Vicinity<N> {
        let ways = self.ways(Level::Velocity, geometry, (q, v));
        let unscaled = vec![1.0; self.count(Level::Velocity)];
        let fastest = self.fastest(q, v);
        // A held square v² that is small asks for the speed √(v²), far above the fastest.
        let root = fastest.sqrt();
        let sizes = [ASIDE * fastest, ASIDE * root, root];
        let sizes = (fastest, &sizes[..if root > fastest { 3 } else { 1 }]);
        self.vicinity(Level::Velocity, (q, v), &ways, sizes, &mut |way, factor| {
            Some(self.gaps(Level::Velocity, q, &(v + way * factor), &unscaled))
        })
    }

    /// Moves q to a pose that satisfies the rows and holds the positions. Values that are far from those of the guess move
    /// in parts, so that the mechanism stays in its assembly.
    fn positions(
        &self,
        geometry: &mut ConstraintGeometry<S, Q, N, R>,
        q: &mut SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<(), Fault> {
        let lengths = self.lengths(Level::Position, q, v);
        let first = self.gaps(Level::Position, q, v, &lengths);
        let farthest = first.iter().fold(0.0, |far: f64, gap| far.max(gap.abs()));
        let strides = (farthest / STRIDE).ceil().clamp(1.0, MOST_STRIDES);
        let mut left = strides;
        while left > 0.0 {
            left -= 1.0;
            let offsets = first.iter().map(|gap| gap * left / strides).collect();
            solve(&mut Positions {
                start: self,
                geometry: &mut *geometry,
                q: &mut *q,
                v,
                lengths: &lengths,
                offsets,
            })?;
        }
        let mut phi = SVector::zeros();
        geometry.evaluate(self.system, 0.0, q, &mut phi)
    }

    /// Moves v to velocities that satisfy the rows and are held.
    pub(super) fn velocities(
        &self,
        geometry: &ConstraintGeometry<S, Q, N, R>,
        q: &SVector<f64, Q>,
        v: &mut SVector<f64, N>,
    ) -> Result<(), Fault> {
        let lengths = self.lengths(Level::Velocity, q, v);
        solve(&mut Velocities {
            start: self,
            geometry,
            q,
            v,
            lengths,
        })
    }

    /// The values that are not held, with what they are off by.
    pub(super) fn open(
        &self,
        level: Level,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
        size: f64,
        vicinity: &Vicinity<N>,
    ) -> Vec<HeldGap> {
        let lengths = self.lengths(level, q, v);
        let gaps = self.gaps(level, q, v, &lengths);
        let open = self.of(level).zip(gaps).zip(&lengths).enumerate();
        let open = open.filter(|(_, ((_, gap), _))| !(gap.abs() <= HELD * size));
        let open = open.map(|(i, ((condition, gap), length))| HeldGap {
            name: condition.name.clone(),
            unit: condition.unit.clone(),
            gap: gap * length,
            is_constant: vicinity.constant.contains(&i),
        });
        open.collect()
    }

    /// The error that these values cannot be held.
    pub(super) fn refused(
        &self,
        level: Level,
        mut open: Vec<HeldGap>,
        degrees_of_freedom: usize,
    ) -> SimulationError {
        open.sort_by(|a, b| b.gap.abs().total_cmp(&a.gap.abs()));
        SimulationError::Held {
            level,
            // A state is free in any case.
            held: (self.of(level).map(|own| own.name.clone()))
                .filter(|name| !S::MODEL.is_state(name))
                .collect(),
            open,
            degrees_of_freedom,
        }
    }

    /// The fastest velocity that is held, in lengths of the mechanism and radians per second.
    pub(super) fn fastest(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        let lengths = self.lengths(Level::Velocity, q, v);
        let still = self.gaps(Level::Velocity, q, &SVector::zeros(), &lengths);
        still.iter().fold(0.0, |most: f64, gap| most.max(gap.abs()))
    }

    /// The changes of the held values as all coordinates change by the length of the mechanism or a radian.
    fn lengths(&self, level: Level, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> Vec<f64> {
        let gradients = self.of(level).map(|condition| {
            let gradient = condition.gradient(self.system, q, v, self.yardstick);
            let length = self.yardstick.row_length_squared(&gradient).sqrt();
            let own = self.own_length(condition);
            if length > 1e-6 * own { length } else { own }
        });
        gradients.collect()
    }

    /// The usual size of such a change.
    pub(super) fn own_length(&self, condition: &Condition) -> f64 {
        match condition.unit.as_str() {
            "m" | "m/s" => self.yardstick.length,
            _ => 1.0,
        }
    }

    /// By how much the held values are off, in these units.
    pub(super) fn gaps(
        &self,
        level: Level,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        lengths: &[f64],
    ) -> Vec<f64> {
        let gap = |condition: &Condition| condition.gap(self.system, q, v, self.yardstick);
        let gaps = self.of(level).map(gap).zip(lengths);
        gaps.map(|(gap, length)| gap / length).collect()
    }

    /// Rows and held values with their derivatives.
    fn linearised(
        &self,
        level: Level,
        geometry: &ConstraintGeometry<S, Q, N, R>,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
        (mut values, lengths): (Vec<f64>, &[f64]),
        gaps: Vec<f64>,
    ) -> Linearised {
        let rows = values.len();
        let weight = |i: usize| self.scale.weights[i].sqrt() * self.scale.tolerance;
        let list = |x: &SVector<f64, N>, factor: f64| {
            let entries = entries(x).iter();
            entries.map(|x| factor * x).collect::<Vec<f64>>()
        };
        let mut linearised = Linearised {
            rows: (0..rows).map(|i| list(&geometry.a[i], weight(i))).collect(),
            lifted: (0..rows).map(|i| list(&geometry.w[i], weight(i))).collect(),
            values: Vec::new(),
        };
        for (condition, length) in self.of(level).zip(lengths) {
            let gradient = condition.gradient(self.system, q, v, self.yardstick);
            let mut lifted = gradient;
            self.system.solve_mass(&geometry.mass, &mut lifted);
            linearised.rows.push(list(&gradient, 1.0 / length));
            linearised.lifted.push(list(&lifted, 1.0 / length));
        }
        values.extend(gaps);
        linearised.values = values;
        linearised
    }

    /// The holonomic rows at q, as displacements.
    fn violations(&self, q: &SVector<f64, Q>) -> Vec<f64> {
        let mut phi = SVector::zeros();
        self.system.holonomic(0.0, q, &mut phi);
        let rows = 0..S::STRUCTURE.holonomic_rows;
        rows.map(|i| self.scale.displacement_of(i, phi[i]).copysign(phi[i]))
            .collect()
    }
}

/// φ(q) = 0, and the held positions.
struct Positions<'a, 'b, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    start: &'a Start<'b, S, Q, N, R>,
    geometry: &'a mut ConstraintGeometry<S, Q, N, R>,
    q: &'a mut SVector<f64, Q>,
    v: &'a SVector<f64, N>,
    lengths: &'a [f64],
    /// What the held values are still to be off by.
    offsets: Vec<f64>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    Positions<'_, '_, S, Q, N, R>
{
    fn gaps(&self, q: &SVector<f64, Q>) -> Vec<f64> {
        let gaps = self.start.gaps(Level::Position, q, self.v, self.lengths);
        let left = gaps.iter().zip(&self.offsets);
        left.map(|(gap, offset)| gap - offset).collect()
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Equations
    for Positions<'_, '_, S, Q, N, R>
{
    fn linearised(&mut self) -> Result<Linearised, Fault> {
        let mut phi = SVector::zeros();
        self.geometry
            .evaluate(self.start.system, 0.0, self.q, &mut phi)?;
        Ok(self.start.linearised(
            Level::Position,
            self.geometry,
            (self.q, self.v),
            (self.start.violations(self.q), self.lengths),
            self.gaps(self.q),
        ))
    }

    fn moves(&mut self, way: &[f64], factor: f64, below: f64) -> bool {
        let way: SVector<f64, N> = vector(|i| way[i]);
        let length = self.start.yardstick.measure(&way);
        let factor = factor * (LONGEST_STEP / length).min(1.0);
        let trial = self.start.system.advance(self.q, &way, factor);
        let mut residual = self.start.violations(&trial);
        residual.extend(self.gaps(&trial));
        let less = norm(&residual) < below;
        if less {
            *self.q = trial;
        }
        less
    }
}

/// A v + b = 0, and the held velocities.
struct Velocities<'a, 'b, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    start: &'a Start<'b, S, Q, N, R>,
    geometry: &'a ConstraintGeometry<S, Q, N, R>,
    q: &'a SVector<f64, Q>,
    v: &'a mut SVector<f64, N>,
    lengths: Vec<f64>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>
    Velocities<'_, '_, S, Q, N, R>
{
    fn violations(&self, v: &SVector<f64, N>) -> Vec<f64> {
        let scale = self.start.scale;
        let rates = self.geometry.velocity_rows(self.start.system, v);
        let rates = entries(&rates).iter().enumerate();
        rates
            .map(|(i, &rate)| scale.displacement_of(i, rate).copysign(rate))
            .collect()
    }

    fn gaps(&self, v: &SVector<f64, N>) -> Vec<f64> {
        self.start.gaps(Level::Velocity, self.q, v, &self.lengths)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Equations
    for Velocities<'_, '_, S, Q, N, R>
{
    fn linearised(&mut self) -> Result<Linearised, Fault> {
        Ok(self.start.linearised(
            Level::Velocity,
            self.geometry,
            (self.q, self.v),
            (self.violations(self.v), &self.lengths),
            self.gaps(self.v),
        ))
    }

    fn moves(&mut self, way: &[f64], factor: f64, below: f64) -> bool {
        let trial: SVector<f64, N> = vector(|i| self.v[i] + factor * way[i]);
        let mut residual = self.violations(&trial);
        residual.extend(self.gaps(&trial));
        let less = norm(&residual) < below;
        if less {
            *self.v = trial;
        }
        less
    }
}
