//! Free flight between the kicks of leapfrog, and its tangents.

use crate::System;
use crate::linear::{RowMatrix, entries, entries_mut};
use crate::memory::Box;
use nalgebra::SVector;

/// Rotation in a step, rad, above which the factors of A₀M⁻¹A₀ᵀ are not used: they neglect the rotation of a kick, and
/// their relative error is half the angle.
const SWIFT: f64 = 0.05;
/// Change of the angle of a step by which the tangent of the flight is taken, rad: round-off leaves seven digits.
const DIFFERENCE: f64 = 1e-8;

#[derive(Clone)]
pub(crate) struct Drift<const Q: usize, const N: usize, const R: usize> {
    h: f64,
    /// q and v before the flight, and after it.
    start: (SVector<f64, Q>, SVector<f64, N>),
    end: (SVector<f64, Q>, SVector<f64, N>),
    /// Whether a body turns by more than the angle above.
    pub(super) swift: bool,
    /// (∂q₁/∂v_a) w / h, row by row.
    directions: RowMatrix<N, R>,
    /// (∂v_b/∂v_a) w, row by row.
    pub(super) far: RowMatrix<N, R>,
}

impl<const Q: usize, const N: usize, const R: usize> Drift<Q, N, R> {
    #[inline(never)]
    pub(super) fn new() -> Box<Self> {
        Box::new(Drift {
            h: 0.0,
            start: (SVector::zeros(), SVector::zeros()),
            end: (SVector::zeros(), SVector::zeros()),
            swift: false,
            directions: RowMatrix::zeros(),
            far: RowMatrix::zeros(),
        })
    }

    pub(super) fn begin<S: System<Q, N, R>>(
        &mut self,
        q: &SVector<f64, Q>,
        va: &SVector<f64, N>,
        h: f64,
    ) {
        (self.start.0, self.h) = (*q, h);
        let va = entries(va);
        let square = |&i: &usize| va[i] * va[i] + va[i + 1] * va[i + 1] + va[i + 2] * va[i + 2];
        let most = S::ROTATIONS.iter().map(square).fold(0.0, f64::max);
        self.swift = h * h * most > SWIFT * SWIFT;
    }

    /// Flies with `v` and returns q₁.
    #[inline]
    pub(super) fn fly<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        v: SVector<f64, N>,
    ) -> SVector<f64, Q> {
        self.start.1 = v;
        self.end = self.start;
        system.free_flight(&mut self.end.0, &mut self.end.1, self.h);
        self.end.0
    }

    /// v after the flight.
    #[inline(always)]
    pub(super) fn velocities(&self) -> &SVector<f64, N> {
        &self.end.1
    }

    /// The rows `w0` after the last flight. The bodies are independent, so that three more flights, each with one
    /// component of all angular velocities changed, give the tangents of all.
    pub(super) fn position_sensitivity<S: System<Q, N, R>>(
        &mut self,
        system: &S,
        w0: &RowMatrix<N, R>,
    ) -> &RowMatrix<N, R> {
        let step = DIFFERENCE / self.h;
        // What a flight turns, and its change of the velocities, for a change of the components k.
        let tangent = |k: usize| {
            let (mut q, mut v) = self.start;
            for &i in S::ROTATIONS {
                v[i + k] += step;
            }
            system.free_flight(&mut q, &mut v, self.h);
            let mut turn = system.difference(&self.end.0, &q);
            let (turn, v) = (entries_mut(&mut turn), entries_mut(&mut v));
            let end = entries(&self.end.1);
            for &i in S::ROTATIONS {
                for j in i..i + 3 {
                    turn[j] /= DIFFERENCE;
                    v[j] = (v[j] - end[j]) / step;
                }
            }
            (*turn, *v)
        };
        let tangents = [tangent(0), tangent(1), tangent(2)];
        for (r, w) in w0.data.0.iter().enumerate() {
            let (mut direction, mut far) = (*w, *w);
            for &i in S::ROTATIONS {
                for j in i..i + 3 {
                    (direction[j], far[j]) = (0.0, 0.0);
                    for (k, (turn, change)) in tangents.iter().enumerate() {
                        direction[j] += turn[j] * w[i + k];
                        far[j] += change[j] * w[i + k];
                    }
                }
            }
            self.directions.entries_mut()[r] = direction;
            self.far.entries_mut()[r] = far;
        }
        &self.directions
    }
}
