//! The constraint rows that depend on others, without dense arrays: the verdict of
//! [`dependence`](crate::linear::dependence) for large mechanisms.
//!
//! The rows are eliminated in declared order, each by those before it, with the largest entry that is left as pivot. What
//! is left of a row differs from it by a combination of rows before it, so that it is at least as long as the part that
//! is orthogonal to them, which decides. If it is nothing the row is dependent; if it is a good part of the row, the row is
//! independent. In between the orthogonal part itself is computed.

use super::{Ldl, SparseRows};
use crate::linear::rank::Dependence;
use crate::singular::NOTHING;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What elimination leaves of a dependent row is longer than its orthogonal part by the condition of the rows before it. A
/// larger value computes orthogonal parts for rows that are independent without doubt, a smaller one trusts the
/// elimination of rows with a worse condition.
const SUSPECT: f64 = 1e-3;

/// Entries that are as large as this fraction of the largest one count as equal: of them the one in a column that fewer
/// rows below need is the pivot. (With a smaller value entries could grow along a chain.)
const ALIKE: f64 = 0.999;

/// Entries below this fraction of what they are the difference of are round-off.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// The numerical rank of A in the metric M⁻¹, and the rows that depend on those above them; `None` if M is not positive
/// definite.
pub(crate) fn dependence(
    a: &SparseRows,
    mass: &SparseRows,
    vanishes: &dyn Fn(usize) -> bool,
) -> Option<Dependence> {
    let inverse = |_, pivot: f64, _| (pivot > 0.0).then(|| 1.0 / pivot);
    let metric = Ldl::new(mass, &inverse).ok()?;
    let mut elimination = Elimination::new(a, mass);
    let (mut kept, mut dependent) = (Vec::new(), Vec::new());
    for i in 0..a.count() {
        let left = elimination.reduce(a.row(i));
        let is_independent = !vanishes(i)
            && match left {
                Left::Much => true,
                Left::Nothing => false,
                Left::Little => {
                    let length = square(&metric, a.row(i)).sqrt();
                    let remainder = square(&metric, elimination.remainder()).sqrt();
                    remainder > NOTHING * length && {
                        let part = orthogonal_part(a, mass, &kept, i);
                        // Written so that NaN, of rows that are no numbers, counts as dependent as with dense arrays.
                        part > NOTHING * length
                    }
                }
            };
        if is_independent {
            elimination.keep();
            kept.push(i);
        } else {
            dependent.push(i);
        }
        elimination.clear();
    }
    Some(Dependence {
        rank: kept.len(),
        dependent,
    })
}

/// x M⁻¹xᵀ.
fn square(metric: &Ldl, x: impl Iterator<Item = (usize, f64)>) -> f64 {
    let x: Vec<(usize, f64)> = x.collect();
    let mut wide = vec![0.0; metric.size()];
    x.iter().for_each(|&(column, value)| wide[column] = value);
    metric.solve(&mut wide);
    let terms = x.iter().map(|&(column, value)| wide[column] * value);
    terms.sum::<f64>().max(0.0)
}

/// How much elimination has left of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Left {
    Nothing,
    Little,
    Much,
}

/// A row after its elimination.
struct PivotRow {
    column: usize,
    pivot: f64,
    /// The other entries.
    rest: Vec<(usize, f64)>,
}

/// Rows in the metric of the diagonal of M, eliminated one by another.
struct Elimination {
    /// 1/√M_jj.
    units: Vec<f64>,
    rows: Vec<PivotRow>,
    /// The row whose pivot is in a column.
    pivot_rows: Vec<Option<usize>>,
    /// How many rows to come have an entry in a column.
    needed: Vec<usize>,
    /// The row at work, and the largest number that each of its entries has been.
    wide: Vec<f64>,
    sizes: Vec<f64>,
    touched: Vec<usize>,
}

impl Elimination {
    fn new(a: &SparseRows, mass: &SparseRows) -> Elimination {
        let size = mass.count();
        let mut needed = vec![0; size];
        for i in 0..a.count() {
            a.row(i).for_each(|(column, _)| needed[column] += 1);
        }
        Elimination {
            units: (0..size).map(|j| 1.0 / mass.get(j, j).sqrt()).collect(),
            rows: Vec::new(),
            pivot_rows: vec![None; size],
            needed,
            wide: vec![0.0; size],
            sizes: vec![0.0; size],
            touched: Vec::new(),
        }
    }

    /// Adds to an entry of the row at work; answers the row that has its pivot there, if the entry is new.
    fn add(&mut self, column: usize, value: f64) -> Option<usize> {
        let is_new = self.sizes[column] == 0.0;
        self.wide[column] += value;
        let size = value.abs().max(self.wide[column].abs());
        // A stored zero is an entry, too.
        self.sizes[column] = self.sizes[column].max(size).max(f64::MIN_POSITIVE);
        if !is_new {
            return None;
        }
        self.touched.push(column);
        self.pivot_rows[column]
    }

    /// Eliminates a row by those that were kept.
    fn reduce(&mut self, row: impl Iterator<Item = (usize, f64)>) -> Left {
        let mut length = 0.0;
        let mut waiting = BinaryHeap::new();
        for (column, value) in row {
            self.needed[column] -= 1;
            let value = value * self.units[column];
            length += value * value;
            waiting.extend(self.add(column, value).map(Reverse));
        }
        // A kept row has entries in columns of pivots only of rows after it.
        while let Some(Reverse(k)) = waiting.pop() {
            let column = self.rows[k].column;
            let factor = self.wide[column] / self.rows[k].pivot;
            self.wide[column] = 0.0;
            if factor == 0.0 {
                continue;
            }
            let rest = std::mem::take(&mut self.rows[k].rest);
            for &(column, value) in &rest {
                waiting.extend(self.add(column, -factor * value).map(Reverse));
            }
            self.rows[k].rest = rest;
        }
        let mut left = 0.0;
        for &column in &self.touched {
            let value = &mut self.wide[column];
            if value.abs() <= ROUND_OFF * self.sizes[column] {
                *value = 0.0;
            }
            left += *value * *value;
        }
        if left == 0.0 {
            Left::Nothing
        } else if left > SUSPECT * SUSPECT * length {
            Left::Much
        } else {
            Left::Little
        }
    }

    /// What is left of the row at work, in the units of A.
    fn remainder(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let columns = self
            .touched
            .iter()
            .map(|&column| (column, self.wide[column]));
        let columns = columns.filter(|&(_, value)| value != 0.0);
        columns.map(|(column, value)| (column, value / self.units[column]))
    }

    /// Keeps what is left of the row at work for the elimination of those after it.
    fn keep(&mut self) {
        let largest = |most: f64, &column: &usize| most.max(self.wide[column].abs());
        let largest = self.touched.iter().fold(0.0, largest);
        let alike = self.touched.iter().copied();
        let alike = alike.filter(|&column| self.wide[column].abs() >= ALIKE * largest);
        let Some(column) = alike.min_by_key(|&column| (self.needed[column], column)) else {
            return;
        };
        let others = self.touched.iter().filter(|&&other| other != column);
        let rest = others.map(|&other| (other, self.wide[other]));
        let rest = rest.filter(|&(_, value)| value != 0.0).collect();
        self.pivot_rows[column] = Some(self.rows.len());
        self.rows.push(PivotRow {
            column,
            pivot: self.wide[column],
            rest,
        });
    }

    /// Clears the row at work.
    fn clear(&mut self) {
        for column in self.touched.drain(..) {
            self.wide[column] = 0.0;
            self.sizes[column] = 0.0;
        }
    }
}

/// The length in the metric M⁻¹ of the part of row i that is orthogonal to the kept rows: that of r = a − Aᵀκ with
///
/// ```text
/// [ M  Aᵀ ] [ M⁻¹r ]   [ a ]
/// [ A  0  ] [  κ   ] = [ 0 ]
/// ```
///
/// where each row stands behind the velocities that it couples.
fn orthogonal_part(a: &SparseRows, mass: &SparseRows, kept: &[usize], i: usize) -> f64 {
    let velocities = mass.count();
    let last = |row: usize| a.row(row).map(|(column, _)| column).max().unwrap_or(0);
    let mut behind = vec![Vec::new(); velocities];
    for (k, &row) in kept.iter().enumerate() {
        behind[last(row)].push(k);
    }
    let mut places = vec![0; velocities + kept.len()];
    let mut place = 0;
    for (velocity, rows) in behind.iter().enumerate() {
        let unknowns = std::iter::once(velocity).chain(rows.iter().map(|k| velocities + k));
        for unknown in unknowns {
            places[unknown] = place;
            place += 1;
        }
    }
    let mut is_row = vec![false; places.len()];
    let mut entries = Vec::new();
    for velocity in 0..velocities {
        let columns = mass.row(velocity);
        entries.extend(columns.map(|(j, value)| (places[velocity], places[j], value)));
    }
    for (k, &row) in kept.iter().enumerate() {
        let place = places[velocities + k];
        is_row[place] = true;
        for (j, value) in a.row(row) {
            entries.extend([(place, places[j], value), (places[j], place, value)]);
        }
    }
    let matrix = SparseRows::new(places.len(), entries);
    let Ok(factor) = Ldl::new(&matrix, &|place, pivot, _| {
        // A pivot of the wrong sign is round-off: its row is nearly dependent itself.
        let is_sound = if is_row[place] {
            pivot < 0.0
        } else {
            pivot > 0.0
        };
        Some(if is_sound { 1.0 / pivot } else { 0.0 })
    }) else {
        // No pivot is refused.
        return f64::NAN;
    };
    let mut rest = vec![0.0; velocities];
    a.row(i).for_each(|(column, value)| rest[column] = value);
    let mut square: f64 = 0.0;
    // The second pass restores the orthogonality that the first loses by cancellation.
    for _ in 0..2 {
        let mut x = vec![0.0; places.len()];
        (0..velocities).for_each(|j| x[places[j]] = rest[j]);
        factor.solve(&mut x);
        for (k, &row) in kept.iter().enumerate() {
            let multiplier = x[places[velocities + k]];
            a.row(row)
                .for_each(|(column, value)| rest[column] -= multiplier * value);
        }
        square = (0..velocities).map(|j| rest[j] * x[places[j]]).sum();
    }
    square.max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{SparseRows, dependence};
    use nalgebra::{SMatrix, SVector};

    const VELOCITIES: usize = 40;
    const ROWS: usize = 36;

    /// A chain of masses whose rows couple neighbours. Every sixth row is a combination of two before it, but for the part
    /// `apart` of another one; the order is that of `order`.
    fn chain(apart: f64, order: impl Fn(usize) -> usize) -> [Vec<(usize, usize, f64)>; 2] {
        let mut mass = Vec::new();
        for i in 0..VELOCITIES {
            mass.push((i, i, 1.0 + 0.1 * (i % 7) as f64));
            if i + 2 < VELOCITIES {
                mass.extend([(i, i + 2, 0.25), (i + 2, i, 0.25)]);
            }
        }
        let mut wide = vec![[0.0; VELOCITIES]; ROWS];
        for i in 0..ROWS {
            let own = [(i, 1.0), (i + 1, 0.3), (i + 3, -((i % 5) as f64))];
            own.iter()
                .for_each(|&(column, value)| wide[i][column] = value);
            if i % 6 == 5 {
                let (a, b, own) = (wide[i - 1], wide[i - 4], wide[i]);
                wide[i] = std::array::from_fn(|j| 2.0 * a[j] - b[j] + apart * own[j]);
            }
        }
        let mut a = Vec::new();
        for (i, row) in wide.iter().enumerate() {
            let entries = row.iter().enumerate().filter(|(_, value)| **value != 0.0);
            a.extend(entries.map(|(column, &value)| (order(i), column, value)));
        }
        [mass, a]
    }

    /// The dependent rows, without dense arrays and with them.
    fn both([mass, a]: [Vec<(usize, usize, f64)>; 2]) -> [Vec<usize>; 2] {
        let [mut wide, mut rows] = [SMatrix::<f64, VELOCITIES, VELOCITIES>::zeros(); 2];
        mass.iter().for_each(|&(i, j, value)| wide[(i, j)] = value);
        a.iter().for_each(|&(i, j, value)| rows[(i, j)] = value);
        let inverse = wide.try_inverse().unwrap();
        let a_rows: [SVector<f64, VELOCITIES>; ROWS] =
            std::array::from_fn(|i| rows.row(i).transpose());
        let w = a_rows.map(|row| inverse * row);
        let dense = crate::linear::dependence(&a_rows, &w, |_| false);
        let [mass, a] =
            [(VELOCITIES, mass), (ROWS, a)].map(|(count, entries)| SparseRows::new(count, entries));
        let sparse = dependence(&a, &mass, &|_| false).unwrap();
        assert_eq!(sparse.rank + sparse.dependent.len(), ROWS);
        [sparse.dependent, dense.dependent]
    }

    #[test]
    fn the_rows_are_those_that_dense_arrays_find() {
        // Between the bounds the orthogonal part decides; beyond them, what elimination leaves.
        for (apart, count) in [(0.0, 6), (1e-10, 6), (1e-6, 0), (1e-4, 0), (0.1, 0)] {
            for step in [1, 5, 7, 35] {
                let [sparse, dense] = both(chain(apart, |i| i * step % ROWS));
                assert_eq!(sparse, dense, "{apart} {step}");
                assert_eq!(dense.len(), count, "{apart} {step}");
            }
        }
        // A combination is named at its last row, whichever that is.
        let [first, last] = [1, 5].map(|step| both(chain(0.0, |i| i * step % ROWS))[0].clone());
        assert_ne!(first, last);
    }

    #[test]
    fn a_row_between_two_that_are_nearly_dependent_follows_from_them() {
        // The first two rows differ by 1e-6, and the third lies between them; the others are zero.
        let mass = (0..VELOCITIES).map(|i| (i, i, 1.0)).collect();
        let mut a = vec![(0, 0, 1.0), (0, 1, 1.0), (1, 0, 1.0), (1, 1, 1.0 + 1e-6)];
        a.extend([
            (2, 0, 1.0),
            (2, 1, 1.0 + 1e-6 / 3.0),
            (3, 2, 1.0),
            (3, 1, 1e-9),
        ]);
        let [sparse, dense] = both([mass, a]);
        assert_eq!(sparse, dense);
        assert_eq!((dense[0], dense.len()), (2, ROWS - 3));
    }

    #[test]
    fn a_mass_matrix_that_is_not_positive_is_refused() {
        let mass = SparseRows::new(2, vec![(0, 0, 1.0), (0, 1, 2.0), (1, 0, 2.0), (1, 1, 1.0)]);
        let a = SparseRows::new(1, vec![(0, 0, 1.0)]);
        assert!(dependence(&a, &mass, &|_| false).is_none());
    }
}
