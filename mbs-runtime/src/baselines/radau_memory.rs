//! What steps of [`Radau`](super::radau::Radau) begin with: the velocities of the step that ended where they start.
//!
//! Some of the last steps are kept, so that a pair of steps goes on where it ended after others were made to compare it with.

use super::radau_coefficients::NODES;
use crate::State;
use crate::linear::{vector, zeros};
use crate::state::rounding;
use nalgebra::SVector;

/// Steps that are kept: a pair, and the one with which it is compared.
const KEPT: usize = 3;

/// Times are the same up to this part of a step: the clock of a simulation makes up for the rounding of their sum.
const ROUNDING: f64 = 1e-6;

/// The inside of a step.
#[derive(Clone, Copy)]
pub(super) struct Known<const N: usize, const R: usize> {
    /// Its length, s.
    pub(super) length: f64,
    /// v at its beginning and at its stages.
    pub(super) velocities: [SVector<f64, N>; 4],
    /// λ at its stages.
    pub(super) multipliers: [SVector<f64, R>; 3],
}

impl<const N: usize, const R: usize> Known<N, R> {
    /// v as a polynomial, at a place after its beginning in lengths of the step.
    pub(super) fn velocities_at(&self, place: f64) -> SVector<f64, N> {
        let [zero, a, b, c] = weights([0.0, NODES[0], NODES[1], NODES[2]], place);
        let [before, first, second, third] = &self.velocities;
        vector(|k| zero * before[k] + a * first[k] + b * second[k] + c * third[k])
    }

    /// λ in the same way.
    pub(super) fn multipliers_at(&self, place: f64) -> SVector<f64, R> {
        let [a, b, c] = weights(NODES, place);
        let [first, second, third] = &self.multipliers;
        vector(|k| a * first[k] + b * second[k] + c * third[k])
    }
}

/// By which the values at nodes are multiplied in the polynomial through them, at a place.
fn weights<const K: usize>(nodes: [f64; K], place: f64) -> [f64; K] {
    std::array::from_fn(|k| {
        let others = nodes.iter().enumerate().filter(|&(other, _)| other != k);
        let factors = others.map(|(_, node)| (place - node) / (nodes[k] - node));
        factors.product()
    })
}

/// A number that differs for different inputs, but for one pair of lists in 2⁶⁴.
fn mark(inputs: &[f64]) -> u64 {
    let mixed = |mark: u64, input: &f64| {
        (mark.rotate_left(5) ^ input.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15)
    };
    inputs.iter().fold(0, mixed)
}

/// A step, and the state at its end.
#[derive(Clone, Copy)]
struct Remembered<const Q: usize, const N: usize, const R: usize> {
    /// Not a number: there is none.
    time: f64,
    positions: SVector<f64, Q>,
    velocities: SVector<f64, N>,
    /// [`mark`] of the inputs during the step.
    inputs: u64,
    known: Known<N, R>,
}

#[derive(Clone)]
pub(super) struct Memory<const Q: usize, const N: usize, const R: usize> {
    steps: Box<[Remembered<Q, N, R>; KEPT]>,
    oldest: usize,
}

impl<const Q: usize, const N: usize, const R: usize> Memory<Q, N, R> {
    pub(super) fn new() -> Self {
        let none = Remembered {
            time: f64::NAN,
            positions: zeros(),
            velocities: zeros(),
            inputs: 0,
            known: Known {
                length: 0.0,
                velocities: [zeros(); 4],
                multipliers: [zeros(); 3],
            },
        };
        Memory {
            steps: Box::new([none; KEPT]),
            oldest: 0,
        }
    }

    /// The step that ended in this state, and whether it had these inputs.
    pub(super) fn before(
        &self,
        state: &State<Q, N, R>,
        inputs: &[f64],
    ) -> Option<(Known<N, R>, bool)> {
        let ended_here = |step: &&Remembered<Q, N, R>| {
            let rounding = ROUNDING * step.known.length.abs() + rounding(state.time);
            (step.time - state.time).abs() <= rounding
                && step.positions == state.positions
                && step.velocities == state.velocities
        };
        let step = self.steps.iter().find(ended_here)?;
        Some((step.known, step.inputs == mark(inputs)))
    }

    /// Keeps a step that has ended in this state, instead of the oldest one.
    pub(super) fn keep(&mut self, state: &State<Q, N, R>, inputs: &[f64], known: Known<N, R>) {
        self.steps[self.oldest] = Remembered {
            time: state.time,
            positions: state.positions,
            velocities: state.velocities,
            inputs: mark(inputs),
            known,
        };
        self.oldest = (self.oldest + 1) % KEPT;
    }
}
