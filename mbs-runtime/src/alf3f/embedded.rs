//! A measure of the error of a composed step, from the velocities between its stages.
//!
//! A composition of symmetric steps of lengths c_i h passes s + 1 states. Of their velocities the sum
//!
//! ```text
//! e = Σ d_i v_i
//! ```
//!
//! is of order hᵃ, whatever the motion, if the d_i satisfy the conditions that follow from the expansion of
//! exp(c h A + c³h³E₃ + c⁵h⁵E₅ + …) in words of A, E₃, E₅, … (S. Blanes, F. Casas, M. Thalhammer, Splitting and composition
//! methods with embedded error estimators, Appl. Numer. Math. 146 (2019) 400–415).
//!
//! | order p | a | order of h e | order of the error of a step |
//! |---|---|---|---|
//! | 4 | 4 | 5 | 5 |
//! | 6 | 6 | 7 | 7 |
//! | 8 | 7 | 8 | 9 |
//!
//! The d_i are the solution of these conditions with the largest term of order a for its length. The factor from h |e| to the
//! error depends on the mechanism: fast rotations, which a flow takes exactly, are in e all the same. It is measured where steps
//! are compared with others of the same length.

use crate::linear::add_scaled;
use crate::yardstick::Yardstick;
use nalgebra::SVector;

/// d_i of the first half of the states, and the factor from them to those of the other half, from the last one on.
type Factors = (&'static [f64], f64);

const FOURTH: Factors = (
    &[
        0.007_246_270_327_065_6,
        0.664_044_973_241_492_6,
        0.328_708_756_431_441_5,
        -0.999_999_999_999_999_8,
    ],
    1.0,
);

const SIXTH: Factors = (
    &[
        -0.106_072_928_749_797_1,
        0.605_342_212_615_991_3,
        -0.584_943_443_050_959_5,
        -0.909_716_492_346_885_2,
        0.999_999_999_999_994_9,
        -0.236_235_523_636_907_8,
        0.231_626_175_168_563_6,
    ],
    1.0,
);

const EIGHTH: Factors = (
    &[
        0.056_897_526_470_309_1,
        0.999_999_999_999_980_2,
        -0.547_784_813_647_348_5,
        -0.424_431_896_597_683_4,
        0.441_378_117_217_871_7,
        -0.411_762_100_732_273_0,
        0.109_757_720_441_553_7,
        0.068_046_688_449_607_2,
        0.938_437_778_740_801_1,
    ],
    -1.0,
);

/// The sum e over the stages of the last step.
#[derive(Clone)]
pub(super) struct Embedded<const N: usize> {
    factors: Factors,
    sum: SVector<f64, N>,
}

impl<const N: usize> Embedded<N> {
    /// For a composition of this order; `None` for a single stage.
    pub(super) fn new(order: u8) -> Option<Self> {
        let factors = match order {
            4 => FOURTH,
            6 => SIXTH,
            8 => EIGHTH,
            _ => return None,
        };
        let sum = SVector::zeros();
        Some(Embedded { factors, sum })
    }

    /// Before the first stage.
    pub(super) fn begin(&mut self, velocities: &SVector<f64, N>) {
        self.sum = SVector::zeros();
        self.add(0, velocities);
    }

    /// After so many stages.
    pub(super) fn add(&mut self, stages: usize, velocities: &SVector<f64, N>) {
        let (first, turned) = self.factors;
        let factor = match first.get(stages) {
            Some(factor) => *factor,
            None => turned * first[2 * first.len() - 1 - stages],
        };
        add_scaled(&mut self.sum, factor, velocities);
    }

    /// h |e|, in sizes of the mechanism and radians.
    pub(super) fn measure<const Q: usize>(&self, h: f64, yardstick: &Yardstick<Q, N>) -> f64 {
        h.abs() * yardstick.measure(&self.sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::alf3f::composition::stages;

    /// e after a step of h of a pendulum, in leapfrog stages.
    fn sum(order: u8, h: f64) -> f64 {
        let mut v = SVector::<f64, 1>::new(0.7);
        let mut q = 1.0;
        let mut embedded = Embedded::new(order).unwrap();
        embedded.begin(&v);
        for (index, fraction) in stages(order).iter().enumerate() {
            let part = fraction * h;
            v[0] -= 0.5 * part * f64::sin(q);
            q += part * v[0];
            v[0] -= 0.5 * part * f64::sin(q);
            embedded.add(index + 1, &v);
        }
        embedded.sum[0].abs()
    }

    #[test]
    fn sums_have_the_orders_of_the_table() {
        for (order, power) in [(4, 4.0), (6, 6.0), (8, 7.0)] {
            let slope = (sum(order, 0.1) / sum(order, 0.05)).log2();
            assert!((slope - power).abs() < 0.2, "order {order}: {slope}");
        }
    }
}
