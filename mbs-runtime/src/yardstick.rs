//! The units of displacements and velocities: the characteristic length of the mechanism for lengths, radians for
//! angles.
//!
//! No length is compared with a metre: the same mechanism in other units of length, mass and time takes the same steps.

#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::linear::{dot, largest, largest_of, products, vector};
use crate::memory::{MOST_POINTS, with_points};
use crate::scalar_state;
use crate::sink::Diagonal;
use crate::{Coordinate, Model, ScalarState, System};
use nalgebra::SVector;

/// Round-off of positions: that of a few operations on numbers of their size.
pub(crate) const ROUND_OFF: f64 = 4.0 * f64::EPSILON;

/// The characteristic length, and the reciprocals of the units of coordinates and velocities.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Yardstick<const Q: usize, const N: usize> {
    /// The characteristic length, m.
    pub(crate) length: f64,
    /// The largest distance of a point from the origin of the world along an axis, m: round-off of lengths is relative
    /// to this.
    pub(crate) reach: f64,
    positions: SVector<f64, Q>,
    velocities: SVector<f64, N>,
}

impl<const Q: usize, const N: usize> Yardstick<Q, N> {
    /// For a system at its guess, so that a resumed run has the same units; `step` is used only if no point gives a
    /// length.
    #[inline(never)]
    pub(crate) fn new<S: System<Q, N, R>, const R: usize>(system: &S, step: f64) -> Self {
        const {
            assert!(
                S::MODEL.points.len() <= MOST_POINTS,
                "without its feature `std` mbs-runtime has room for 64 points of a mechanism"
            );
        }
        let (q, _) = system.guess();
        let (reach, extent) = with_points(
            S::MODEL.points.len(),
            |points| system.points(0.0, &q, points),
            |points| {
                let points = &points[..points.len().saturating_sub(S::MODEL.marks)];
                (largest_of(points.as_flattened()), extent(points))
            },
        );
        let length = [extent, reach]
            .into_iter()
            .find(|&length| is_length(length))
            .unwrap_or_else(|| without_points(system, step));
        let mut yardstick = Self::of(S::MODEL.coordinates, S::MODEL.velocities, length, reach);
        yardstick.leave_out(S::STATES);
        yardstick
    }

    /// The same, with a length of at least the round-off of positions divided by `tolerance`.
    pub(crate) fn for_tolerance(
        &self,
        model: &Model,
        states: &[ScalarState],
        tolerance: f64,
    ) -> Self {
        let length = self.length.max(ROUND_OFF / tolerance * self.reach);
        let mut yardstick = Self::of(model.coordinates, model.velocities, length, self.reach);
        yardstick.leave_out(states);
        yardstick
    }

    fn of(coordinates: &[Coordinate], velocities: &[Coordinate], length: f64, reach: f64) -> Self {
        let weight = |quantity: Option<&Coordinate>| match quantity {
            Some(quantity) if matches!(quantity.unit, "m" | "m/s") => 1.0 / length,
            _ => 1.0,
        };
        Yardstick {
            length,
            reach,
            positions: vector(|i| weight(coordinates.get(i))),
            velocities: vector(|i| weight(velocities.get(i))),
        }
    }

    /// States are no motion.
    fn leave_out(&mut self, states: &[ScalarState]) {
        for state in states {
            self.positions[state.coordinate] = 0.0;
            self.velocities[state.velocity] = 0.0;
        }
    }

    /// Whether a velocity is that of a motion, and no state.
    pub(crate) fn is_motion(&self, velocity: usize) -> bool {
        self.velocities[velocity] > 0.0
    }

    /// x in the unit of a velocity as a displacement; of a state in its own unit.
    fn scaled(&self, velocity: usize, x: f64) -> f64 {
        match self.is_motion(velocity) {
            true => x / self.velocities[velocity],
            false => x,
        }
    }

    /// The size of a correction of the velocities v. That of a state is relative to it, and counts as this part of
    /// `whole`.
    #[inline(always)]
    pub(crate) fn correction(
        &self,
        states: &[ScalarState],
        (change, v): (&SVector<f64, N>, &SVector<f64, N>),
        whole: impl FnOnce() -> f64,
    ) -> f64 {
        let size = self.measure(change);
        if states.is_empty() {
            return size;
        }
        let own = scalar_state::relative(states, change, v) * whole();
        // A size that is not a number stays one.
        if own > size { own } else { size }
    }

    /// max |x| in lengths of the mechanism and radians; NaN if any is not a number.
    #[inline(always)]
    pub(crate) fn measure(&self, x: &SVector<f64, N>) -> f64 {
        largest(&self.sizes(x))
    }

    /// Σ x² in the same units.
    pub(crate) fn square(&self, x: &SVector<f64, N>) -> f64 {
        let sizes = self.sizes(x);
        dot(&sizes, &sizes)
    }

    /// The index of the largest entry, as in [`Self::measure`].
    pub(crate) fn worst(&self, x: &SVector<f64, N>) -> usize {
        let sizes = self.sizes(x);
        let larger = |i: &usize, j: &usize| sizes[*i].abs().total_cmp(&sizes[*j].abs());
        (0..N).max_by(larger).unwrap_or(0)
    }

    #[inline(always)]
    pub(crate) fn sizes(&self, x: &SVector<f64, N>) -> SVector<f64, N> {
        products(&self.velocities, x)
    }

    /// x whose entries are these numbers of lengths of the mechanism, of radians, or of units of a state.
    pub(crate) fn displacement(&self, parts: SVector<f64, N>) -> SVector<f64, N> {
        vector(|i| self.scaled(i, parts[i]))
    }

    /// |a|² of a row in these units.
    #[inline]
    pub(crate) fn row_length_squared(&self, a: &SVector<f64, N>) -> f64 {
        let moved: SVector<f64, N> = vector(|i| self.scaled(i, a[i]));
        dot(&moved, &moved)
    }

    /// The same of a row with these entries.
    #[cfg(feature = "std")]
    pub(crate) fn length_squared(&self, entries: impl Iterator<Item = (usize, f64)>) -> f64 {
        let moved = entries.map(|(column, value)| self.scaled(column, value).powi(2));
        moved.sum()
    }

    /// The largest coordinate in these units, at least 1.
    #[inline(always)]
    pub(crate) fn farthest(&self, q: &SVector<f64, Q>) -> f64 {
        largest(&products(&self.positions, q)).max(1.0)
    }

    /// Round-off of positions in these units.
    #[inline(always)]
    pub(crate) fn round_off_of_positions(&self, q: &SVector<f64, Q>) -> f64 {
        ROUND_OFF * self.farthest(q)
    }

    /// A velocity, in lengths of the mechanism and radians per second, that changes the positions at the end of a step
    /// of h by no more than their round-off. At rest the corrections stay of this size: the rate 2φ/h of a row has this
    /// error, and a smaller step makes it larger.
    #[inline(always)]
    pub(crate) fn imperceptible(&self, q: &SVector<f64, Q>, h: f64) -> f64 {
        self.round_off_of_positions(q) / (0.5 * h).abs()
    }
}

/// The characteristic length of a mechanism all of whose points lie at the origin: the largest radius of gyration, or
/// the distance of its first step; without both, no length is needed, and any value can be used.
#[cold]
fn without_points<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    step: f64,
) -> f64 {
    let (q, v) = system.guess();
    let mut mass = Diagonal::<N>::zeros();
    system.mass_matrix(&q, &mut mass);
    let unit = |i: usize| S::MODEL.velocities.get(i).map_or("", |v| v.unit);
    let most = |wanted: &str, of: &dyn Fn(usize) -> f64| {
        let is_state = |i: usize| S::STATES.iter().any(|state| state.velocity == i);
        let among = (0..N).filter(|&i| unit(i) == wanted && !is_state(i));
        among.map(of).fold(0.0, f64::max)
    };
    let inertia = |i: usize| mass.0[i];
    let gyration = (most("rad/s", &inertia) / most("m/s", &inertia)).sqrt();
    let mut kick = SVector::zeros();
    system.applied_forces(0.0, &q, &v, &mut kick);
    if let Some(mass) = system.factor_mass(&q) {
        system.solve_mass(&mass, &mut kick);
    }
    let way = |i: usize| step * (v[i].abs() + step * kick[i].abs());
    let way = most("m/s", &way);
    [gyration, way]
        .into_iter()
        .find(|&length| is_length(length))
        .unwrap_or(1.0)
}

fn is_length(x: f64) -> bool {
    x > 0.0 && x.is_finite()
}

/// The largest extent of points along an axis, m.
fn extent(points: &[[f64; 3]]) -> f64 {
    let along = |axis: usize| {
        let values = points.iter().map(|point| point[axis]);
        let least = values.clone().fold(f64::INFINITY, f64::min);
        values.fold(f64::NEG_INFINITY, f64::max) - least
    };
    along(0).max(along(1)).max(along(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    const VELOCITIES: [Coordinate; 2] = [
        Coordinate {
            name: "x'",
            unit: "m/s",
        },
        Coordinate {
            name: "theta'",
            unit: "rad/s",
        },
    ];
    const COORDINATES: [Coordinate; 2] = [
        Coordinate {
            name: "x",
            unit: "m",
        },
        Coordinate {
            name: "theta",
            unit: "rad",
        },
    ];

    #[test]
    fn lengths_count_in_sizes_and_angles_in_radians() {
        let length = extent(&[[1.0, -1.0, 0.0], [2.0, 3.0, 0.0]]);
        let yardstick = Yardstick::<2, 2>::of(&COORDINATES, &VELOCITIES, length, 3.0);
        assert_eq!(yardstick.measure(&SVector::from([2.0, 0.25])), 0.5);
        assert_eq!(yardstick.worst(&SVector::from([2.0, 0.25])), 0);
        assert_eq!(yardstick.measure(&SVector::from([0.5, -0.25])), 0.25);
        assert_eq!(yardstick.worst(&SVector::from([0.5, -0.25])), 1);
        assert!(yardstick.measure(&SVector::from([f64::NAN, 0.0])).is_nan());
        assert_eq!(
            yardstick.row_length_squared(&SVector::from([0.5, 2.0])),
            8.0
        );
        assert_eq!(yardstick.farthest(&SVector::from([-12.0, 2.0])), 3.0);
    }
}
