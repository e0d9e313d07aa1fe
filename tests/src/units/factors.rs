//! Vectors and matrices whose entries are multiplied by factors.

use mbs_runtime::generated::{self, Elimination};
use mbs_runtime::nalgebra::{SMatrix, SVector};

/// Slot, row and column of the entries of A in the array of K: where A v of a single entry is not zero, and by which v.
pub(super) fn entries<const N: usize, const R: usize>(plan: &Elimination<N, R>) -> Vec<[usize; 3]> {
    let mut k = vec![0.0; plan.slots];
    let numbers = SVector::from_fn(|j, _| (j + 1) as f64);
    let mut found = Vec::new();
    for slot in 0..plan.slots {
        let mut rates = SVector::zeros();
        k[slot] = 1.0;
        (plan.rates)(&k, &numbers, &mut rates);
        k[slot] = 0.0;
        let entry = rates.iter().enumerate().find(|(_, rate)| **rate != 0.0);
        found.extend(entry.map(|(row, number)| [slot, row, *number as usize - 1]));
    }
    found
}

/// Each entry by its factor, or divided by it.
pub(super) fn times<const K: usize>(
    x: &SVector<f64, K>,
    factor: impl Fn(usize) -> f64,
) -> SVector<f64, K> {
    let mut scaled = *x;
    for (i, value) in generated::entries_mut(&mut scaled).iter_mut().enumerate() {
        *value *= factor(i);
    }
    scaled
}

pub(super) fn over<const K: usize>(
    x: &SVector<f64, K>,
    factor: impl Fn(usize) -> f64,
) -> SVector<f64, K> {
    let mut scaled = *x;
    for (i, value) in generated::entries_mut(&mut scaled).iter_mut().enumerate() {
        *value /= factor(i);
    }
    scaled
}

/// Each entry of rows by its factor, of the row and the column.
pub(super) fn each<const N: usize, const R: usize>(
    matrix: &SMatrix<f64, N, R>,
    factor: impl Fn(usize, usize) -> f64,
) -> SMatrix<f64, N, R> {
    let mut scaled = *matrix;
    for (row, entries) in generated::rows_mut(&mut scaled).iter_mut().enumerate() {
        for (i, value) in entries.iter_mut().enumerate() {
            *value *= factor(row, i);
        }
    }
    scaled
}
