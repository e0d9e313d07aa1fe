//! States of a mechanism ([`ScalarState`]) among its velocities: each in its own unit, of its own size.
//!
//! A state is no motion: [`Yardstick`](crate::yardstick::Yardstick) leaves it out of speeds and distances. Its errors
//! and corrections are relative to its value, or to its scale where it is less.

use crate::{Model, ScalarState};
use nalgebra::SVector;

/// The part of a state that is a large correction.
const MUCH: f64 = 0.3;

impl ScalarState {
    /// The size of this state, in its own unit.
    #[inline(always)]
    fn size(&self, v: &[f64]) -> f64 {
        v[self.velocity].abs().max(self.scale)
    }
}

/// The largest change of a state, relative to its size; 0 without states. It leaves no code where there are none.
#[inline(always)]
pub(crate) fn relative<const N: usize>(
    states: &[ScalarState],
    change: &SVector<f64, N>,
    v: &SVector<f64, N>,
) -> f64 {
    let (change, [v]) = (&change.data.0[0], &v.data.0);
    let parts = states.iter();
    let parts = parts.map(|state| change[state.velocity].abs() / state.size(v));
    parts.fold(0.0, f64::max)
}

/// Whether a correction changes a state so much that the tangent before it says little of the next one: a step may be far
/// longer than the time constant of a state, and its rate far from linear over the step.
#[inline(always)]
pub(crate) fn changes_much<const N: usize>(
    states: &[ScalarState],
    change: &SVector<f64, N>,
    v: &SVector<f64, N>,
) -> bool {
    !states.is_empty() && relative(states, change, v) > MUCH
}

/// The sum of their squares.
#[inline(always)]
pub(crate) fn square<const N: usize>(
    states: &[ScalarState],
    change: &SVector<f64, N>,
    v: &SVector<f64, N>,
) -> f64 {
    let (change, [v]) = (&change.data.0[0], &v.data.0);
    let parts = states.iter();
    let parts = parts.map(|state| change[state.velocity] / state.size(v));
    parts.map(|part| part * part).sum()
}

/// The states of a mechanism with the scales of its parameters: the sizes of these values.
pub fn with_scales<const K: usize>(
    declared: &'static [ScalarState],
    values: [f64; K],
) -> [ScalarState; K] {
    core::array::from_fn(|i| ScalarState {
        scale: usual_size(values[i]),
        ..declared[i]
    })
}

/// The scale that follows from a declared one, which is positive, or from the initial value: 1 in SI units where that is 0.
fn usual_size(initial: f64) -> f64 {
    match initial.is_finite() && initial != 0.0 {
        true => initial.abs(),
        false => 1.0,
    }
}

impl Model {
    /// The `State`s, in declaration order, with their initial values as defaults. Each is an output and a velocity of
    /// the same name.
    pub fn states(&self) -> impl Iterator<Item = &'static crate::Quantity> + use<> {
        let (outputs, velocities) = (self.outputs, self.velocities);
        outputs.iter().filter(move |output| {
            let mut names = velocities.iter().map(|velocity| velocity.name);
            names.any(|name| name == output.name)
        })
    }

    /// Whether a velocity of this name is a state.
    pub(crate) fn is_state(&self, velocity: &str) -> bool {
        // (Of thousands of outputs not each is compared with each velocity.)
        self.velocities.iter().any(|own| own.name == velocity)
            && self.outputs.iter().any(|own| own.name == velocity)
    }

    /// Whether the coordinate of this name is the integral of a state over time, on which nothing depends.
    pub(crate) fn is_integral(&self, coordinate: &str) -> bool {
        let state = coordinate.strip_suffix(".integral");
        state.is_some_and(|state| self.is_state(state))
    }
}
