//! The derivatives of a step, entry by entry, and those that finite rotations turn.

use crate::System;
use crate::flow::right_tangent;
use crate::linear::sparse::{Columns, Entries, Pattern, Recorder};
use nalgebra::SVector;

/// M, the tangents of a step, and A at its two ends.
#[derive(Clone)]
pub(super) struct Tangents {
    pub(super) mass: Entries,
    pub(super) f_q: Entries,
    pub(super) f_v: Entries,
    pub(super) p_q: Entries,
    pub(super) start: Entries,
    pub(super) end: Entries,
}

impl Tangents {
    /// With the places of all entries.
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        system: &S,
        t: f64,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
    ) -> Self {
        let [mut mass, mut f_q, mut f_v, mut p_q, mut a] =
            std::array::from_fn(|_| Recorder::default());
        system.balance_tangents(t, q, v, &mut mass, &mut f_q, &mut f_v, &mut p_q);
        let (mut phi, mut b) = (SVector::zeros(), SVector::zeros());
        system.constraints(t, q, &mut phi, &mut a, &mut b);
        let a = Entries::of(a);
        Tangents {
            mass: Entries::of(mass),
            f_q: Entries::of(f_q),
            f_v: Entries::of(f_v),
            p_q: Entries::of(p_q),
            start: a.clone(),
            end: a,
        }
    }

    /// Evaluates M and the tangents at an instant.
    pub(super) fn evaluate<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        &mut self,
        system: &S,
        t: f64,
        (q, v): (&SVector<f64, Q>, &SVector<f64, N>),
    ) {
        let Tangents {
            mass,
            f_q,
            f_v,
            p_q,
            ..
        } = self;
        let (mass, f_q) = (&mut mass.sink(), &mut f_q.sink());
        let (f_v, p_q) = (&mut f_v.sink(), &mut p_q.sink());
        system.balance_tangents(t, q, v, mass, f_q, f_v, p_q);
    }
}

/// B, and below it A₁T of the holonomic rows.
#[derive(Clone)]
pub(super) struct Turned {
    pub(super) columns: Columns,
    pub(super) values: Vec<f64>,
    p_q: Vec<usize>,
    f_q: Vec<usize>,
    /// Of each entry of A: none for nonholonomic rows, on which T does not act.
    pub(super) rows: Vec<Option<usize>>,
}

impl Turned {
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        tangents: &Tangents,
    ) -> Self {
        let mut pattern = Pattern::new(N);
        let holonomic = S::STRUCTURE.holonomic_rows;
        for &(row, column) in tangents.p_q.places.iter().chain(&tangents.f_q.places) {
            pattern.insert(row, column);
        }
        for &(row, column) in &tangents.end.places {
            if row < holonomic {
                pattern.insert(N + row, column);
            }
        }
        pattern.join_threes(S::ROTATIONS);
        let columns = pattern.finish();
        let rows = tangents.end.places.iter();
        let rows = rows.map(|&(i, j)| (i < holonomic).then(|| columns.slot(N + i, j)));
        Turned {
            values: vec![0.0; columns.rows.len()],
            p_q: columns.slots(&tangents.p_q),
            f_q: columns.slots(&tangents.f_q),
            rows: rows.collect(),
            columns,
        }
    }

    pub(super) fn fill<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        &mut self,
        tangents: &Tangents,
        turn: &SVector<f64, N>,
        h: f64,
    ) {
        let values = &mut self.values;
        values.fill(0.0);
        for (&slot, value) in self.p_q.iter().zip(&tangents.p_q.values) {
            values[slot] += value;
        }
        for (&slot, value) in self.f_q.iter().zip(&tangents.f_q.values) {
            values[slot] -= 0.5 * h * value;
        }
        for (slot, value) in self.rows.iter().zip(&tangents.end.values) {
            if let Some(slot) = *slot {
                values[slot] += value;
            }
        }
        let starts = &self.columns.starts;
        for &i in S::ROTATIONS {
            let tangent = right_tangent([turn[i], turn[i + 1], turn[i + 2]]);
            // The three columns have entries in the same rows.
            let length = starts[i + 1] - starts[i];
            for entry in starts[i]..starts[i] + length {
                let at = [entry, entry + length, entry + 2 * length];
                let own = at.map(|slot| values[slot]);
                for (k, &slot) in at.iter().enumerate() {
                    values[slot] = (0..3).map(|j| own[j] * tangent[j][k]).sum();
                }
            }
        }
    }
}
