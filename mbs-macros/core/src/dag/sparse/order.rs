//! In which order the unknowns of a sparse symmetric matrix are eliminated.

use super::fill::{column_operations, fill};
use std::collections::BTreeSet;

/// An elimination from both ends may take this many operations more, in hundredths.
const MORE: usize = 5;

/// Where minimum degree begins among equals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum From {
    First,
    Last,
}

/// Minimum degree: each time the unknown with the fewest couplings to the remaining unknowns; of equals the first, or the
/// last.
///
/// A row comes after all velocities that it couples. Then every leading part of the matrix is that of a mechanism
/// with whole rows, whose pivots are those of M (positive) and of the rows' Schur complement (negative), and a row's
/// pivot vanishes only where rows lose their independence.
fn minimum_degree(
    mut neighbours: Vec<BTreeSet<usize>>,
    velocities: usize,
    from: From,
) -> Vec<usize> {
    let count = neighbours.len();
    let turned = |unknown: usize| match from {
        From::First => unknown,
        From::Last => count - 1 - unknown,
    };
    // With fill a row has more neighbours than the velocities that it couples.
    let coupled = neighbours.clone();
    let mut waits_for: Vec<usize> = (0..count)
        .map(|unknown| match unknown < velocities {
            true => 0,
            false => coupled[unknown].len(),
        })
        .collect();
    // Those that can be next, by the number of their couplings.
    let mut ready: BTreeSet<(usize, usize)> = (0..count)
        .filter(|&unknown| waits_for[unknown] == 0)
        .map(|unknown| (neighbours[unknown].len(), turned(unknown)))
        .collect();
    let mut cliques = Cliques::new(count);
    let mut order = Vec::with_capacity(count);
    while let Some((_, next)) = ready.pop_first() {
        let next = turned(next);
        order.push(next);
        for &row in coupled[next].iter().filter(|&&other| other >= velocities) {
            waits_for[row] -= 1;
            if waits_for[row] == 0 {
                ready.insert((neighbours[row].len(), turned(row)));
            }
        }
        let around = std::mem::take(&mut neighbours[next]);
        let fills_in = cliques.eliminate(next, &around);
        for &unknown in &around {
            let before = neighbours[unknown].len();
            neighbours[unknown].remove(&next);
            if fills_in {
                let others = around.iter().copied().filter(|&other| other != unknown);
                neighbours[unknown].extend(others);
            }
            if ready.remove(&(before, turned(unknown))) {
                ready.insert((neighbours[unknown].len(), turned(unknown)));
            }
        }
    }
    order
}

/// Sets of unknowns that an elimination has coupled with one another. Unknowns of one set are coupled already, so that eliminating n
/// of them changes n² couplings, not n³.
struct Cliques {
    /// How many of each set are not eliminated.
    left: Vec<usize>,
    /// The sets of each unknown.
    of: Vec<Vec<usize>>,
}

impl Cliques {
    fn new(count: usize) -> Cliques {
        Cliques {
            left: Vec::new(),
            of: vec![Vec::new(); count],
        }
    }

    /// Eliminates an unknown with the couplings `around`; returns whether these may have to be coupled.
    fn eliminate(&mut self, unknown: usize, around: &BTreeSet<usize>) -> bool {
        let mut fills_in = around.len() > 1;
        for &clique in &self.of[unknown] {
            self.left[clique] -= 1;
            // All that are left of a set are around each of it.
            fills_in &= self.left[clique] != around.len();
        }
        if fills_in {
            for &other in around {
                self.of[other].push(self.left.len());
            }
            self.left.push(around.len());
        }
        fills_in
    }
}

/// Minimum degree from the first unknown on, and from the last one on where that takes hardly more operations: a chain is
/// eliminated from both ends to its middle, and no column of one half waits for one of the other.
pub(super) fn from_both_ends(neighbours: &[BTreeSet<usize>], velocities: usize) -> Vec<usize> {
    let by_degree = |from: From| minimum_degree(neighbours.to_vec(), velocities, from);
    let first = by_degree(From::First);
    let below = fill(neighbours, &first);
    let mut links = link_by_link(&below);
    if links.len() > 1 {
        return first;
    }
    let mut both: Vec<usize> = links.pop().unwrap_or_default();
    both.truncate(first.len() / 2);
    both.iter_mut()
        .for_each(|position| *position = first[*position]);
    let taken: BTreeSet<usize> = both.iter().copied().collect();
    let last = by_degree(From::Last).into_iter();
    both.extend(last.filter(|unknown| !taken.contains(unknown)));
    let operations = |below: &[BTreeSet<usize>]| -> usize {
        below
            .iter()
            .map(|below| column_operations(below.len()))
            .sum()
    };
    let [one, two] = [operations(&below), operations(&fill(neighbours, &both))];
    match 100 * two <= (100 + MORE) * one {
        true => both,
        false => first,
    }
}

/// The same elimination link by link: each column directly after those that it depends on, where minimum degree goes from
/// one end of a chain to the other several times.
///
/// A column depends on those in which it is the first entry below the pivot. These are a tree, and any order in which a
/// column comes after its branches has the same fill (Liu, SIAM J. Matrix Anal. Appl. 11, 1990). Of the branches the
/// largest, the chain so far, comes first. Returns each tree by itself.
pub(super) fn link_by_link(below: &[BTreeSet<usize>]) -> Vec<Vec<usize>> {
    let count = below.len();
    let mut branches: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut sizes = vec![1; count];
    let mut roots = Vec::new();
    for (position, below) in below.iter().enumerate() {
        match below.first() {
            Some(&next) => {
                sizes[next] += sizes[position];
                branches[next].push(position);
            }
            None => roots.push(position),
        }
    }
    let trees = roots.into_iter().map(|root| {
        // Backwards: a column, then its branches, the smallest first.
        let (mut tree, mut left) = (Vec::with_capacity(sizes[root]), vec![root]);
        while let Some(position) = left.pop() {
            tree.push(position);
            let mut own = std::mem::take(&mut branches[position]);
            own.sort_by_key(|&branch| std::cmp::Reverse((sizes[branch], branch)));
            left.extend(own);
        }
        tree.reverse();
        tree
    });
    trees.collect()
}

/// Trees of one form in turns, a column of each: their solutions do not wait for one another. (The masses of a chain in
/// natural coordinates have a tree for each direction.)
pub(super) fn in_turns(trees: Vec<Vec<usize>>, below: &[BTreeSet<usize>]) -> Vec<usize> {
    let mut places = vec![0; below.len()];
    for tree in &trees {
        for (place, &position) in tree.iter().enumerate() {
            places[position] = place;
        }
    }
    let form = |tree: &[usize]| -> Vec<Vec<usize>> {
        let own = tree.iter().map(|&position| &below[position]);
        own.map(|below| below.iter().map(|&i| places[i]).collect())
            .collect()
    };
    let mut order = Vec::with_capacity(below.len());
    for alike in trees.chunk_by(|a, b| form(a) == form(b)) {
        for place in 0..alike[0].len() {
            order.extend(alike.iter().map(|tree| tree[place]));
        }
    }
    order
}
