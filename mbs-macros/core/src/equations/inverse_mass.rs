//! The structure of M⁻¹ where M is constant: its blocks, and which of them are equal.

use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::{BTreeMap, HashMap};

/// Which entries of M⁻¹ are zero, and which are equal, by structure.
///
/// Coordinates that M does not couple are not coupled by M⁻¹ either. And where two blocks of M are the same matrix (for
/// bars: one of the x, one of the y components), so are their inverses, and code that uses them shares its constants.
#[derive(Debug, Clone)]
pub struct InverseMass {
    /// The block of each coordinate.
    block: Vec<usize>,
    /// The coordinates of each block, ascending.
    members: Vec<Vec<usize>>,
    /// For each coordinate the one in its place in the first block that is equal to its own.
    twin: Vec<usize>,
}

/// A block of M: its size, and its entries by their places in it.
type Signature = (usize, Vec<((usize, usize), Expr)>);

impl InverseMass {
    /// The structure of the inverse of M, given by its upper triangle.
    pub fn new(size: usize, mass: &BTreeMap<(usize, usize), Expr>) -> Self {
        let (block, members) = blocks(size, mass.keys().copied());
        let mut place = vec![0; size];
        for list in &members {
            list.iter().zip(0..).for_each(|(&i, k)| place[i] = k);
        }
        let count = members.len();
        let sizes = members.iter().map(|list| (list.len(), Vec::new()));
        let mut signatures: Vec<Signature> = sizes.collect();
        for (&(i, j), &entry) in mass {
            signatures[block[i]].1.push(((place[i], place[j]), entry));
        }
        let mut twin: Vec<usize> = (0..size).collect();
        let mut seen: HashMap<Signature, usize> = HashMap::with_capacity(count);
        for (own, signature) in signatures.into_iter().enumerate() {
            let first = *seen.entry(signature).or_insert(own);
            for (&own, &other) in members[own].iter().zip(&members[first]) {
                twin[own] = other;
            }
        }
        InverseMass {
            block,
            members,
            twin,
        }
    }

    /// Whether entry (i, j) may differ from zero.
    pub fn couples(&self, i: usize, j: usize) -> bool {
        self.block[i] == self.block[j]
    }

    /// The block of a coordinate.
    pub fn block(&self, i: usize) -> usize {
        self.block[i]
    }

    /// The coordinates that a coordinate is coupled with, itself among them, ascending.
    pub fn coupled(&self, i: usize) -> &[usize] {
        &self.members[self.block[i]]
    }

    /// The number of entries that may differ from zero.
    pub fn entries(&self) -> usize {
        let sizes = self.members.iter().map(Vec::len);
        sizes.map(|size| size * size).sum()
    }

    /// The symbol of entry (i, j): the same for equal entries.
    pub fn entry(&self, graph: &mut Graph, i: usize, j: usize) -> Expr {
        let (i, j) = (self.twin[i], self.twin[j]);
        graph.symbol(Symbol::InverseMass(i.min(j) as u32, i.max(j) as u32))
    }

    /// M⁻¹ x.
    pub fn apply(&self, graph: &mut Graph, x: &[Expr]) -> Vec<Expr> {
        (0..x.len())
            .map(|i| {
                let mut terms = Vec::new();
                for &j in self.coupled(i) {
                    let inverse = self.entry(graph, i, j);
                    terms.push(graph.mul(inverse, x[j]));
                }
                graph.sum(terms)
            })
            .collect()
    }
}

/// The block of each coordinate, and the coordinates of each block; blocks in the order of their first coordinates.
fn blocks(
    size: usize,
    couplings: impl Iterator<Item = (usize, usize)>,
) -> (Vec<usize>, Vec<Vec<usize>>) {
    // Each coordinate points to one before it in its block, or to itself.
    let mut before: Vec<usize> = (0..size).collect();
    let first = |before: &mut Vec<usize>, mut i: usize| {
        while before[i] != i {
            before[i] = before[before[i]];
            i = before[i];
        }
        i
    };
    for (i, j) in couplings {
        let (a, b) = (first(&mut before, i), first(&mut before, j));
        before[a.max(b)] = a.min(b);
    }
    let mut block = vec![0; size];
    let mut members: Vec<Vec<usize>> = Vec::new();
    for i in 0..size {
        let leader = first(&mut before, i);
        if leader == i {
            block[i] = members.len();
            members.push(Vec::new());
        } else {
            block[i] = block[leader];
        }
        members[block[i]].push(i);
    }
    (block, members)
}
