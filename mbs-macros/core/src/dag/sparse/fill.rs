//! What an order of elimination fills in, and what it costs.

use std::collections::BTreeSet;

/// Multiplications and additions that eliminate a column with so many entries below its pivot.
pub(super) fn column_operations(below: usize) -> usize {
    below * (below + 2) + 5
}

/// The positions of the entries below each pivot, for this order.
pub(super) fn fill(neighbours: &[BTreeSet<usize>], order: &[usize]) -> Vec<BTreeSet<usize>> {
    let mut positions = vec![0; order.len()];
    for (position, &unknown) in order.iter().enumerate() {
        positions[unknown] = position;
    }
    let mut below: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); order.len()];
    for (position, &unknown) in order.iter().enumerate() {
        let later = neighbours[unknown].iter().map(|&other| positions[other]);
        below[position].extend(later.filter(|&other| other > position));
        // The entries of a column below its first one are also entries of the column of the first one.
        let mut fill = below[position].iter().copied();
        if let Some(first) = fill.next() {
            let fill: Vec<usize> = fill.collect();
            below[first].extend(fill);
        }
    }
    below
}
