//! The two matrices of an implicit step without their zeros:
//!
//! ```text
//! [ J    −½(A₀ + A₁)ᵀ ]        [ M₁ − h/2 F_v   −A₁ᵀ ]
//! [ A₁T   ε D         ]        [ A₁              ε D ]
//! ```
//!
//! J = M₁ + h/2 (B − F_v), B = (p_q − h/2 F_q) T. D holds estimates of a M⁻¹aᵀ. With ε the matrices of redundant rows are
//! regular, too: one solution is then one step of the augmented Lagrangian iteration, which Newton's method and the
//! passes of the projection continue.

use crate::System;
use crate::flow::right_tangent;
use crate::linear::sparse::{Columns, Entries, Pattern, Recorder, SparseLu};
use nalgebra::SVector;

/// ε: rows that add less than its root to the others are regularised.
const PROXIMAL: f64 = 1e-10;

/// M, the tangents of a step, and A at its two ends.
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
}

/// B, and below it A₁T of the holonomic rows.
struct Turned {
    columns: Columns,
    values: Vec<f64>,
    p_q: Vec<usize>,
    f_q: Vec<usize>,
    /// Of each entry of A: none for nonholonomic rows, on which T does not act.
    rows: Vec<Option<usize>>,
}

/// The matrices; they have one pattern.
pub(super) struct Saddle {
    pub(super) lu: SparseLu,
    turned: Turned,
    slots: Slots,
    /// D.
    lengths: Vec<f64>,
}

/// Where the entries stand in the matrix.
struct Slots {
    /// Of B and A₁T …
    turned: Vec<usize>,
    mass: Vec<usize>,
    f_v: Vec<usize>,
    /// … of A below and beside J …
    below: Vec<usize>,
    beside: Vec<usize>,
    /// … and the diagonal of the rows.
    proximal: Vec<usize>,
    /// Where M has its diagonal among its entries.
    diagonal: Vec<Option<usize>>,
}

impl Saddle {
    /// Analyses the pattern; `None` if it is singular.
    pub(super) fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        tangents: &Tangents,
    ) -> Option<Self> {
        let turned = Turned::new::<S, Q, N, R>(tangents);
        let a = &tangents.end.places;
        let mut pattern = Pattern::new(N + R);
        for (row, column) in turned.columns.places() {
            pattern.insert(row, column);
        }
        for &(row, column) in tangents.mass.places.iter().chain(&tangents.f_v.places) {
            pattern.insert(row, column);
        }
        for &(row, column) in a {
            pattern.insert(N + row, column);
            pattern.insert(column, N + row);
        }
        for row in 0..R {
            pattern.insert(N + row, N + row);
        }
        let columns = pattern.finish();
        let slots = |entries: &Entries| -> Vec<usize> {
            let places = entries.places.iter();
            places.map(|&(i, j)| columns.slot(i, j)).collect()
        };
        let of_turned = turned.columns.places().map(|(i, j)| columns.slot(i, j));
        let mut diagonal = vec![None; N];
        for (k, &(i, j)) in tangents.mass.places.iter().enumerate() {
            if i == j {
                diagonal[i] = Some(k);
            }
        }
        let places = Slots {
            turned: of_turned.collect(),
            mass: slots(&tangents.mass),
            f_v: slots(&tangents.f_v),
            below: a.iter().map(|&(i, j)| columns.slot(N + i, j)).collect(),
            beside: a.iter().map(|&(i, j)| columns.slot(j, N + i)).collect(),
            proximal: (0..R).map(|i| columns.slot(N + i, N + i)).collect(),
            diagonal,
        };
        Some(Saddle {
            lengths: vec![0.0; R],
            lu: SparseLu::new(&columns)?,
            slots: places,
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
        let Saddle {
            lu,
            turned,
            slots,
            lengths,
        } = self;
        let values = slots.start(lu, lengths, tangents, 0.5 * h);
        let entries = turned.values.iter().zip(&turned.columns.rows);
        for (&slot, (&value, &row)) in slots.turned.iter().zip(entries) {
            values[slot] += if row < N { 0.5 * h * value } else { value };
        }
        let ends = tangents.start.values.iter().zip(&tangents.end.values);
        for (k, (before, after)) in ends.enumerate() {
            values[slots.beside[k]] -= 0.5 * (before + after);
            if turned.rows[k].is_none() {
                values[slots.below[k]] += after;
            }
        }
        lu.factor()
    }

    /// Factors the matrix of the projection.
    pub(super) fn factor_velocities(&mut self, tangents: &Tangents, h: f64) -> bool {
        let (lu, slots) = (&mut self.lu, &self.slots);
        let values = slots.start(lu, &mut self.lengths, tangents, 0.5 * h);
        for (k, value) in tangents.end.values.iter().enumerate() {
            values[slots.beside[k]] -= value;
            values[slots.below[k]] += value;
        }
        lu.factor()
    }
}

impl Slots {
    /// M − damping F_v and ε D, and zeros elsewhere.
    fn start<'a>(
        &self,
        lu: &'a mut SparseLu,
        lengths: &mut [f64],
        tangents: &Tangents,
        damping: f64,
    ) -> &'a mut [f64] {
        let Tangents { mass, f_v, end, .. } = tangents;
        lengths.fill(0.0);
        for (row, column, value) in end.iter() {
            let inertia = self.diagonal[column].map_or(0.0, |k| mass.values[k]);
            lengths[row] += value * value / if inertia > 0.0 { inertia } else { 1.0 };
        }
        let values = lu.values();
        values.fill(0.0);
        for (&slot, value) in self.mass.iter().zip(&mass.values) {
            values[slot] += value;
        }
        for (&slot, value) in self.f_v.iter().zip(&f_v.values) {
            values[slot] -= damping * value;
        }
        for (&slot, &length) in self.proximal.iter().zip(&*lengths) {
            // A row that vanishes altogether gets no multiplier.
            values[slot] += if length > 0.0 { PROXIMAL * length } else { 1.0 };
        }
        values
    }
}

impl Turned {
    fn new<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
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
        let slots = |entries: &Entries| -> Vec<usize> {
            let places = entries.places.iter();
            places.map(|&(i, j)| columns.slot(i, j)).collect()
        };
        let rows = tangents.end.places.iter();
        let rows = rows.map(|&(i, j)| (i < holonomic).then(|| columns.slot(N + i, j)));
        Turned {
            values: vec![0.0; columns.rows.len()],
            p_q: slots(&tangents.p_q),
            f_q: slots(&tangents.f_q),
            rows: rows.collect(),
            columns,
        }
    }

    fn fill<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
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
