//! Outputs, events, points and reactions.

use super::NamedValues;
use crate::{Held, ScalarState};
use nalgebra::SVector;

/// Outputs, events, points and reactions of a mechanism with Q coordinates, N velocities and R constraint rows.
pub trait Observables<const Q: usize, const N: usize, const R: usize> {
    /// The `Output`s as fields.
    type Outputs: NamedValues;
    /// The initial values that assembly holds, in declaration order.
    const HELD: &'static [Held] = &[];
    /// Whether an `Output` reads accelerations or reactions.
    const HAS_OUTPUTS_AT_ACCELERATION_LEVEL: bool = false;
    /// The `State`s, in declaration order, with the defaults of all parameters.
    const STATES: &'static [ScalarState] = &[];

    /// The same with the scales that follow from the parameters of this system. A wrapper that forwards `STATES` forwards this, too.
    #[inline(always)]
    fn states(&self) -> &[ScalarState] {
        Self::STATES
    }
    /// `Output`s, in the order of [`Model::outputs`](crate::Model::outputs) (a shorter slice receives the first ones).
    /// Those that read accelerations or reactions become NaN, or are not written.
    fn outputs(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, outputs: &mut [f64]);
    /// All `Output`s, from accelerations v̇ and multipliers λ as those of [`Self::reactions`].
    fn outputs_at_acceleration_level(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        acceleration: &SVector<f64, N>,
        lambda: &SVector<f64, R>,
        outputs: &mut [f64],
    ) {
        let _ = (acceleration, lambda);
        self.outputs(t, q, v, outputs);
    }
    /// `Event` expressions, in the order of [`Model::events`](crate::Model::events).
    fn events(&self, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, events: &mut [f64]);
    /// Two numbers for each of [`Self::HELD`]: by how much it exceeds its declared value, and its rate (a velocity itself).
    fn held(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, held: &mut [f64]) {
        let _ = (q, v, held);
    }
    /// Points in world axes, m, in the order of [`Model::points`](crate::Model::points).
    fn points(&self, t: f64, q: &SVector<f64, Q>, points: &mut [[f64; 3]]);
    /// Joint reactions from accelerations v̇ and multipliers λ (of M v̇ + Γvv = f + Aᵀλ), in the order of
    /// [`Model::reactions`](crate::Model::reactions).
    fn reactions(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        acceleration: &SVector<f64, N>,
        lambda: &SVector<f64, R>,
        reactions: &mut [f64],
    );
}
