//! What the operations of a function are about.

use super::signature;
use crate::dag::{Function, Program};
use crate::symbolic::Map;

impl Program {
    /// The parts and joints on which most operations of a function depend: those of the largest group of operations that
    /// depend on the same.
    pub fn dominant(&self, function: &Function) -> Vec<&str> {
        let (signatures, sets) = signature::with_sets(function, &self.labels);
        let mut counts: Map<u32, usize> = Map::default();
        for [depends_on, ..] in signatures {
            *counts.entry(depends_on).or_default() += 1;
        }
        // Of groups of one size the one that was found first: the message is always the same.
        let largest = counts
            .into_iter()
            .max_by_key(|&(set, count)| (count, std::cmp::Reverse(set)));
        let labels = largest.into_iter().flat_map(|(set, _)| sets.labels(set));
        labels.filter_map(|label| self.labels.name(label)).collect()
    }
}
