//! The structure of M⁻¹ where M is constant: its blocks, and which of them are equal.

use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeMap;

/// Which entries of M⁻¹ are zero, and which are equal, by structure.
///
/// Coordinates that M does not couple are not coupled by M⁻¹ either. And where two blocks of M are the same matrix (for
/// bars: one of the x, one of the y components), so are their inverses, and code that uses them shares its constants.
#[derive(Debug, Clone)]
pub struct InverseMass {
    /// The block of each coordinate.
    block: Vec<usize>,
    /// For each coordinate the one in its place in the first block that is equal to its own.
    twin: Vec<usize>,
}

impl InverseMass {
    /// The structure of the inverse of M, given by its upper triangle.
    pub fn new(size: usize, mass: &BTreeMap<(usize, usize), Expr>) -> Self {
        let mut block: Vec<usize> = (0..size).collect();
        for &(i, j) in mass.keys() {
            let (a, b) = (block[i], block[j]);
            if a != b {
                block
                    .iter_mut()
                    .filter(|entry| **entry == b)
                    .for_each(|entry| *entry = a);
            }
        }
        let members =
            |name: usize| -> Vec<usize> { (0..size).filter(|&i| block[i] == name).collect() };
        let entries = |list: &[usize]| -> Vec<Option<Expr>> {
            let pairs = list
                .iter()
                .enumerate()
                .flat_map(|(k, &i)| list[k..].iter().map(move |&j| (i, j)));
            pairs.map(|slot| mass.get(&slot).copied()).collect()
        };
        let mut twin: Vec<usize> = (0..size).collect();
        let mut seen: Vec<(Vec<Option<Expr>>, Vec<usize>)> = Vec::new();
        for i in 0..size {
            let list = members(block[i]);
            if list[0] != i {
                continue;
            }
            let signature = entries(&list);
            match seen.iter().find(|(known, _)| *known == signature) {
                Some((_, first)) => list
                    .iter()
                    .zip(first)
                    .for_each(|(&own, &other)| twin[own] = other),
                None => seen.push((signature, list)),
            }
        }
        InverseMass { block, twin }
    }

    /// Whether entry (i, j) may differ from zero.
    pub fn couples(&self, i: usize, j: usize) -> bool {
        self.block[i] == self.block[j]
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
                for j in (0..x.len()).filter(|&j| self.couples(i, j)) {
                    let inverse = self.entry(graph, i, j);
                    terms.push(graph.mul(inverse, x[j]));
                }
                graph.sum(terms)
            })
            .collect()
    }
}
