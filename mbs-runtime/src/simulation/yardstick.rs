//! What errors and motions are measured in: the size of the mechanism for lengths, radians for angles.

use crate::Coordinate;
use crate::linear::{finite, largest, vector};
use nalgebra::SVector;

/// Weights of the velocities: 1/size for those in m/s, 1 for those in rad/s.
pub(super) struct Yardstick<const N: usize> {
    weights: SVector<f64, N>,
}

impl<const N: usize> Yardstick<N> {
    /// For a mechanism with these velocities and, at the start, these points.
    pub(super) fn new(velocities: &[Coordinate], points: &[[f64; 3]]) -> Self {
        let size = extent(points);
        Yardstick {
            weights: vector(|i| match velocities.get(i) {
                Some(velocity) if velocity.unit == "m/s" => 1.0 / size,
                _ => 1.0,
            }),
        }
    }

    /// max |x| in sizes and radians; infinite if any is not a number.
    pub(super) fn measure(&self, x: &SVector<f64, N>) -> f64 {
        let sizes = self.sizes(x);
        match finite(&sizes) {
            true => largest(&sizes),
            false => f64::INFINITY,
        }
    }

    /// The entry that [`Self::measure`] comes from.
    pub(super) fn worst(&self, x: &SVector<f64, N>) -> usize {
        let sizes = self.sizes(x).map(f64::abs);
        let larger = |i: &usize, j: &usize| sizes[*i].total_cmp(&sizes[*j]);
        (0..N).max_by(larger).unwrap_or(0)
    }

    fn sizes(&self, x: &SVector<f64, N>) -> SVector<f64, N> {
        vector(|i| self.weights[i] * x[i])
    }
}

/// The largest extent of points along an axis, m; 1 where there is none.
fn extent(points: &[[f64; 3]]) -> f64 {
    let along = |axis: usize| {
        let values = points.iter().map(|point| point[axis]);
        let least = values.clone().fold(f64::INFINITY, f64::min);
        values.fold(f64::NEG_INFINITY, f64::max) - least
    };
    let extent = along(0).max(along(1)).max(along(2));
    if extent > 0.0 && extent.is_finite() {
        extent
    } else {
        1.0
    }
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

    #[test]
    fn lengths_count_in_sizes_and_angles_in_radians() {
        let points = [[1.0, -1.0, 0.0], [2.0, 3.0, 0.0]];
        let yardstick = Yardstick::new(&VELOCITIES, &points);
        assert_eq!(yardstick.measure(&SVector::from([2.0, 0.25])), 0.5);
        assert_eq!(yardstick.worst(&SVector::from([2.0, 0.25])), 0);
        assert_eq!(yardstick.measure(&SVector::from([0.5, -0.25])), 0.25);
        assert_eq!(yardstick.worst(&SVector::from([0.5, -0.25])), 1);
        assert_eq!(
            yardstick.measure(&SVector::from([f64::NAN, 0.0])),
            f64::INFINITY
        );
    }

    #[test]
    fn without_an_extent_lengths_are_metres() {
        let yardstick = Yardstick::new(&VELOCITIES, &[[1.0; 3]]);
        assert_eq!(yardstick.measure(&SVector::from([2.0, 0.25])), 2.0);
    }
}
