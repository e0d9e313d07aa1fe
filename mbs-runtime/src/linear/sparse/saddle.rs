//! The matrix of velocities and multipliers:
//!
//! ```text
//! [ J    −Bᵀ ]
//! [ A    ε D ]
//! ```
//!
//! J has the pattern of M and more, B that of A. D holds estimates of a M⁻¹aᵀ. With ε the matrices of redundant rows are
//! regular, too: one solution is then one step of the augmented Lagrangian iteration, which the iteration that uses it
//! continues.

use super::{Columns, Entries, Pattern, SparseLu};

/// ε: rows that add less than its root to the others are regularised.
///
/// Directions whose inertia is about ε are corrected by half of what is missing each time. Where many of them fade
/// together, as in a scissor lift whose stages are all flat, some have any inertia between that of one and its 10⁻⁶-th
/// part: with 1e-10 corrections do not settle there. If ε is smaller than this, it is lost in the round-off of the pivots.
const PROXIMAL: f64 = 1e-14;

/// The matrix, and its factors.
#[derive(Clone)]
pub(crate) struct Saddle {
    pub(crate) lu: SparseLu,
    pub(crate) columns: Columns,
    /// Where the entries of M stand, of A, of Bᵀ, and of D.
    mass: Vec<usize>,
    pub(crate) below: Vec<usize>,
    pub(crate) beside: Vec<usize>,
    proximal: Vec<usize>,
    /// Where M has its diagonal among its entries.
    diagonal: Vec<Option<usize>>,
    /// D.
    lengths: Vec<f64>,
}

impl Saddle {
    /// For these numbers of velocities and rows; `more` are places beside those of M and A. `None` if the pattern is
    /// singular.
    pub(crate) fn new(
        [velocities, rows]: [usize; 2],
        mass: &Entries,
        a: &Entries,
        more: impl Iterator<Item = (usize, usize)>,
    ) -> Option<Self> {
        let mut pattern = Pattern::new(velocities + rows);
        for (row, column) in more.chain(mass.places.iter().copied()) {
            pattern.insert(row, column);
        }
        for &(row, column) in &a.places {
            pattern.insert(velocities + row, column);
            pattern.insert(column, velocities + row);
        }
        for unknown in velocities..velocities + rows {
            pattern.insert(unknown, unknown);
        }
        let columns = pattern.finish();
        let mut diagonal = vec![None; velocities];
        for (k, &(i, j)) in mass.places.iter().enumerate() {
            if i == j {
                diagonal[i] = Some(k);
            }
        }
        let places = a.places.iter().map(|&(i, j)| (velocities + i, j));
        Some(Saddle {
            mass: columns.slots(mass),
            below: places.clone().map(|(i, j)| columns.slot(i, j)).collect(),
            beside: places.map(|(i, j)| columns.slot(j, i)).collect(),
            proximal: (velocities..velocities + rows)
                .map(|i| columns.slot(i, i))
                .collect(),
            lengths: vec![0.0; rows],
            lu: match rows {
                0 => SparseLu::with_diagonal_pivots(&columns),
                _ => SparseLu::new(&columns),
            }?,
            diagonal,
            columns,
        })
    }

    /// Writes M and ε D, and zeros elsewhere.
    pub(crate) fn begin(&mut self, mass: &Entries, a: &Entries) {
        self.lengths.fill(0.0);
        for (row, column, value) in a.iter() {
            let inertia = self.diagonal[column].map_or(0.0, |k| mass.values[k]);
            self.lengths[row] += value * value / if inertia > 0.0 { inertia } else { 1.0 };
        }
        let values = self.lu.values();
        values.fill(0.0);
        for (&slot, value) in self.mass.iter().zip(&mass.values) {
            values[slot] += value;
        }
        for (&slot, &length) in self.proximal.iter().zip(&self.lengths) {
            // A row that vanishes altogether gets no multiplier.
            values[slot] += if length > 0.0 { PROXIMAL * length } else { 1.0 };
        }
    }

    /// The diagonal entry ε D of a row.
    pub(crate) fn proximal(&self, row: usize) -> f64 {
        PROXIMAL * self.lengths[row]
    }

    /// Adds A of these rows below, and −Aᵀ beside.
    pub(crate) fn add_rows(&mut self, a: &Entries, rows: std::ops::Range<usize>) {
        let values = self.lu.values();
        for (k, (row, _, value)) in a.iter().enumerate() {
            if rows.contains(&row) {
                values[self.below[k]] += value;
                values[self.beside[k]] -= value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Recorder;
    use super::{Entries, Saddle};
    use crate::MatrixSink;

    fn entries(list: &[(usize, usize, f64)]) -> Entries {
        let mut recorder = Recorder::default();
        (list.iter()).for_each(|&(row, column, value)| recorder.set(row, column, value));
        let mut entries = Entries::of(recorder);
        (entries.values.iter_mut().zip(list)).for_each(|(place, entry)| *place = entry.2);
        entries
    }

    /// What a solution leaves of two rows that differ by this angle.
    fn left_at(angle: f64) -> f64 {
        let mass = entries(&[(0, 0, 1.0), (1, 1, 1.0)]);
        let rows = [(0, 0, 1.0), (1, 0, 1.0), (1, 1, angle)];
        let a = entries(&rows);
        let mut saddle = Saddle::new([2, 2], &mass, &a, std::iter::empty()).unwrap();
        saddle.begin(&mass, &a);
        saddle.add_rows(&a, 0..2);
        assert!(saddle.lu.factor());
        let mut x = [0.0, 0.0, 0.0, angle];
        assert!(saddle.lu.solve(&mut x));
        (x[0] + angle * x[1] - angle).abs().max(x[0].abs()) / angle
    }

    #[test]
    fn directions_that_fade_are_corrected_and_lost_ones_are_not() {
        assert!(left_at(1e-5) < 1e-3, "{}", left_at(1e-5));
        assert!(left_at(1e-10) > 0.1, "{}", left_at(1e-10));
    }
}
