//! The normal equations A Aᵀ y = x of many rows, which are as sparse as the mechanism.
//!
//! They square the condition of A: a row can be told from a dependent one if more than 1e-7 of it is left, so that they
//! serve to assemble poses, and to confirm that all rows are independent. Where they find a row that may be dependent,
//! the rows are orthogonalised (see `rows`).

use std::collections::BTreeMap;

/// Where the factor has more entries than this for each row, it is given up.
const MOST_ENTRIES: usize = 64;

/// A row of A without its zeros: (column, entry).
pub(super) type SparseRow = Vec<(usize, f64)>;

/// A Aᵀ = L D Lᵀ in the order of the rows.
pub(super) struct Normal {
    /// Index and entries of each row.
    rows: Vec<(usize, SparseRow)>,
    /// D; `None` where little is left of a row.
    pivots: Vec<Option<f64>>,
    /// L below its diagonal, column by column: (position of the row, entry).
    columns: Vec<Vec<(usize, f64)>>,
}

impl Normal {
    /// Factors A Aᵀ. Rows of which less than `threshold` is left are left out. `None` if it is not sparse.
    pub fn new(rows: Vec<(usize, SparseRow)>, threshold: f64) -> Option<Normal> {
        let most = MOST_ENTRIES * rows.len();
        let mut below = products(&rows, most)?;
        let count = rows.len();
        let mut entries: usize = below.iter().map(BTreeMap::len).sum();
        let mut normal = Normal {
            rows,
            pivots: Vec::with_capacity(count),
            columns: Vec::with_capacity(count),
        };
        for position in 0..count {
            let mut column: Vec<(usize, f64)> =
                std::mem::take(&mut below[position]).into_iter().collect();
            let (_, pivot) = column.remove(0);
            let row = &normal.rows[position].1;
            let square: f64 = row.iter().map(|(_, x)| x * x).sum();
            // Written so that NaN is left out.
            if !(pivot > threshold * threshold * square) {
                normal.pivots.push(None);
                normal.columns.push(Vec::new());
                continue;
            }
            for (place, &(i, across)) in column.iter().enumerate() {
                let scaled = across / pivot;
                for &(j, other) in &column[place..] {
                    let known = below[i].len();
                    *below[i].entry(j).or_insert(0.0) -= scaled * other;
                    entries += below[i].len() - known;
                }
            }
            if entries > most {
                return None;
            }
            column.iter_mut().for_each(|(_, entry)| *entry /= pivot);
            normal.pivots.push(Some(pivot));
            normal.columns.push(column);
        }
        Some(normal)
    }

    /// Whether no row was left out.
    pub fn is_regular(&self) -> bool {
        self.pivots.iter().all(Option::is_some)
    }

    /// Takes the part along the rows out of a vector.
    pub fn remove_from(&self, vector: &mut [f64]) {
        // Twice, because of round-off.
        for _ in 0..2 {
            let rows = self.rows.iter();
            let along = rows.map(|(_, row)| row.iter().map(|&(j, x)| x * vector[j]).sum());
            let along = self.solve(along.collect());
            self.subtract(&along, vector);
        }
    }

    /// −A⁺ φ in velocities, over rows that have a φ.
    pub fn correction(&self, size: usize, phi: &[f64]) -> Vec<f64> {
        let rows = self.rows.iter();
        let demand = rows.map(|&(row, _)| phi.get(row).copied().unwrap_or(0.0));
        let along = self.solve(demand.collect());
        let mut change = vec![0.0; size];
        self.subtract(&along, &mut change);
        change
    }

    /// x ← x − Aᵀ y.
    fn subtract(&self, y: &[f64], x: &mut [f64]) {
        for ((_, row), y) in self.rows.iter().zip(y) {
            for &(j, entry) in row {
                x[j] -= entry * y;
            }
        }
    }

    /// y of A Aᵀ y = x; zero for rows that were left out.
    fn solve(&self, mut x: Vec<f64>) -> Vec<f64> {
        for (position, column) in self.columns.iter().enumerate() {
            for &(i, entry) in column {
                x[i] -= entry * x[position];
            }
        }
        for position in (0..x.len()).rev() {
            x[position] = match self.pivots[position] {
                Some(pivot) => {
                    let column = self.columns[position].iter();
                    let known: f64 = column.map(|&(i, entry)| entry * x[i]).sum();
                    x[position] / pivot - known
                }
                None => 0.0,
            };
        }
        x
    }
}

/// A Aᵀ on and below its diagonal, column by column; `None` if it has more entries than `most`.
fn products(rows: &[(usize, SparseRow)], most: usize) -> Option<Vec<BTreeMap<usize, f64>>> {
    let entries = rows.iter().flat_map(|(_, row)| row);
    let columns = entries.map(|&(column, _)| column + 1).max();
    let mut meeting: Vec<Vec<(usize, f64)>> = vec![Vec::new(); columns.unwrap_or(0)];
    let mut below = vec![BTreeMap::new(); rows.len()];
    let mut entries = 0;
    for (position, (_, row)) in rows.iter().enumerate() {
        below[position].insert(position, 0.0);
        for &(column, x) in row {
            let met = &mut meeting[column];
            met.push((position, x));
            entries += met.len();
            if entries > most {
                return None;
            }
            for &(earlier, other) in met.iter() {
                *below[earlier].entry(position).or_insert(0.0) += x * other;
            }
        }
    }
    Some(below)
}
