//! The error of a step of Radau IIA by its embedded formula (Hairer, Wanner: Solving Ordinary Differential Equations II, IV.8 (8.19)).

use crate::ScalarState;
use crate::estimate::Estimate;
use crate::linear::zeros;
use crate::scalar_state::relative;
use crate::yardstick::Yardstick;
use nalgebra::SVector;

/// The error of a step has the order 6 in h, what its embedded formula gives 4, and as a part of the way 3.
const ORDERS: f64 = 2.0 / 3.0;

/// Of the last step, at its end.
#[derive(Clone, Copy)]
pub(super) struct Errors<const N: usize> {
    /// The estimates of the errors of θ and v by the embedded formula.
    pub(super) turn: SVector<f64, N>,
    pub(super) change: SVector<f64, N>,
    /// θ.
    pub(super) way: SVector<f64, N>,
    /// The change of v.
    pub(super) gained: SVector<f64, N>,
    /// The work of forces without potential by the embedded formula less that of the step, and that of the step, J; 0 without rows
    /// of time.
    pub(super) works: [f64; 2],
}

impl<const N: usize> Errors<N> {
    /// Before the first step.
    pub(super) fn none() -> Self {
        Errors {
            turn: zeros(),
            change: zeros(),
            way: zeros(),
            gained: zeros(),
            works: [0.0; 2],
        }
    }

    /// Of a step of h. The formula has the order 3. A power of what it gives, as a part of the way, has the order of the step.
    /// `end`: v at the end of the step.
    pub(super) fn estimate<const Q: usize>(
        &self,
        h: f64,
        (yardstick, states): (&Yardstick<Q, N>, &[ScalarState]),
        end: &SVector<f64, N>,
    ) -> Estimate {
        let error = yardstick
            .measure(&self.turn)
            .max(h * yardstick.measure(&self.change));
        let of_order = |error: f64, whole: f64| match error < whole {
            true => error * (error / whole).powf(ORDERS),
            false => error,
        };
        let [off, work] = self.works;
        let error = of_order(error, yardstick.measure(&self.way));
        // Each state by its own gain: another one may change by more.
        let of_state = |state: &ScalarState| {
            let state = core::slice::from_ref(state);
            let [own, gained] =
                [&self.change, &self.gained].map(|change| relative(state, change, end));
            [own, of_order(own, gained)]
        };
        let largest = |largest: [f64; 2], of: [f64; 2]| [0, 1].map(|k| largest[k].max(of[k]));
        Estimate {
            of_states: states.iter().map(of_state).fold([0.0; 2], largest),
            ..Estimate::smooth(error, of_order(off, work))
        }
    }
}
