//! In which order the unknowns of a sparse symmetric matrix are eliminated.

use std::collections::BTreeSet;

/// Minimum degree: each time the unknown with the fewest couplings to the remaining unknowns; of equals the first.
///
/// A row comes after all velocities that it couples. Then every leading part of the matrix is that of a mechanism
/// with whole rows, whose pivots are those of M (positive) and of the rows' Schur complement (negative), and a row's
/// pivot vanishes only where rows lose their independence.
pub(super) fn minimum_degree(
    mut neighbours: Vec<BTreeSet<usize>>,
    velocities: usize,
) -> Vec<usize> {
    let count = neighbours.len();
    // With fill a row has more neighbours than the velocities that it couples.
    let coupled = neighbours.clone();
    let mut waits_for: Vec<usize> = (0..count)
        .map(|unknown| match unknown < velocities {
            true => 0,
            false => coupled[unknown].len(),
        })
        .collect();
    let mut left: BTreeSet<usize> = (0..count).collect();
    let mut order = Vec::with_capacity(count);
    while let Some(&next) = left
        .iter()
        .filter(|&&unknown| waits_for[unknown] == 0)
        .min_by_key(|&&unknown| neighbours[unknown].len())
    {
        left.remove(&next);
        order.push(next);
        for &row in coupled[next].iter().filter(|&&other| other >= velocities) {
            waits_for[row] -= 1;
        }
        let around = std::mem::take(&mut neighbours[next]);
        for &unknown in &around {
            neighbours[unknown].remove(&next);
            let others = around.iter().copied().filter(|&other| other != unknown);
            neighbours[unknown].extend(others);
        }
    }
    order
}
