//! The two matrices of an implicit step without their zeros:
//!
//! ```text
//! [ J    −½(A₀ + A₁)ᵀ ]        [ M₁ − h/2 F_v   −A₁ᵀ ]
//! [ A₁T   ε D         ]        [ A₁              ε D ]
//! ```
//!
//! J = M₁ + h/2 (B − F_v), B = (p_q − h/2 F_q) T. Of the nonholonomic rows A₁ itself stands in the first matrix. The
//! second is that of the projection; without rows there is none.

use super::tangents::{Tangents, Turned};
use crate::System;
use crate::linear::sparse::Saddle;
use nalgebra::SVector;

/// The matrices; they have one pattern.
#[derive(Clone)]
pub(super) struct StepMatrices {
    pub(super) positions: Saddle,
    pub(super) velocities: Option<Saddle>,
    turned: Turned,
    /// Where B and A₁T stand, and F_v.
    of_turned: Vec<usize>,
    f_v: Vec<usize>,
}

impl StepMatrices {
    /// Analyses the pattern; `None` if it is singular.
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        tangents: &Tangents,
    ) -> Option<Self> {
        let turned = Turned::new::<S, Q, N, R>(tangents);
        let Tangents { mass, f_v, end, .. } = tangents;
        let more = turned.columns.places();
        let more = more.chain(f_v.places.iter().copied());
        let saddle = Saddle::new([N, R], mass, end, more)?;
        let columns = &saddle.columns;
        let of_turned = turned.columns.places().map(|(i, j)| columns.slot(i, j));
        Some(StepMatrices {
            of_turned: of_turned.collect(),
            f_v: columns.slots(f_v),
            velocities: (R > 0).then(|| saddle.clone()),
            positions: saddle,
            turned,
        })
    }

    /// Factors the matrix of Newton's method; `turn` is h/2 (v₀ + v_b).
    pub(super) fn factor_positions<S, const Q: usize, const N: usize, const R: usize>(
        &mut self,
        tangents: &Tangents,
        turn: &SVector<f64, N>,
        h: f64,
    ) -> bool
    where
        S: System<Q, N, R>,
    {
        self.turned.fill::<S, Q, N, R>(tangents, turn, h);
        let (turned, saddle) = (&self.turned, &mut self.positions);
        begin(saddle, &self.f_v, tangents, h);
        let values = saddle.lu.values();
        let entries = turned.values.iter().zip(&turned.columns.rows);
        for (&slot, (&value, &row)) in self.of_turned.iter().zip(entries) {
            values[slot] += if row < N { 0.5 * h * value } else { value };
        }
        let ends = tangents.start.values.iter().zip(&tangents.end.values);
        for (k, (before, after)) in ends.enumerate() {
            values[saddle.beside[k]] -= 0.5 * (before + after);
            if turned.rows[k].is_none() {
                values[saddle.below[k]] += after;
            }
        }
        saddle.lu.factor()
    }

    /// Factors the matrix of the projection, if there is one.
    pub(super) fn factor_velocities<const R: usize>(
        &mut self,
        tangents: &Tangents,
        h: f64,
    ) -> bool {
        let Some(saddle) = &mut self.velocities else {
            return true;
        };
        begin(saddle, &self.f_v, tangents, h);
        saddle.add_rows(&tangents.end, 0..R);
        saddle.lu.factor()
    }
}

/// M₁ − h/2 F_v and ε D.
fn begin(saddle: &mut Saddle, f_v: &[usize], tangents: &Tangents, h: f64) {
    saddle.begin(&tangents.mass, &tangents.end);
    let values = saddle.lu.values();
    for (&slot, value) in f_v.iter().zip(&tangents.f_v.values) {
        values[slot] -= 0.5 * h * value;
    }
}
