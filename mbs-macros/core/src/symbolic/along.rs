//! Which terms of a long sum change along a symbol.
//!
//! An energy is a sum over all parts, and each coordinate changes the terms of a few. The terms are listed by symbol
//! once, so that all derivatives together take time in proportion to the sum.

use super::{Expr, Graph, Map, Node, Number, Symbol};
use std::sync::Arc;

/// The terms of a shorter sum are all looked at.
const LONG: usize = 32;

impl Graph {
    /// The terms of a sum that may change along a symbol, in order.
    pub(super) fn terms_along(&mut self, sum: Expr, symbol: Symbol) -> Vec<(Expr, Number)> {
        let terms = self.terms(sum);
        if terms.len() <= LONG {
            let may_change = |&&(term, _): &&(Expr, Number)| self.may_depend_on(term, symbol);
            return terms.iter().filter(may_change).copied().collect();
        }
        if !self.along.contains_key(&sum) {
            let lists = Arc::new(self.list_along(terms));
            self.along.insert(sum, lists);
        }
        let terms = self.terms(sum);
        let indices = self.along.get(&sum).and_then(|lists| lists.get(&symbol));
        let indices = indices.map_or(&[][..], Vec::as_slice);
        indices.iter().map(|&index| terms[index as usize]).collect()
    }

    fn terms(&self, sum: Expr) -> &[(Expr, Number)] {
        match self.node(sum) {
            Node::Sum { terms, .. } => terms,
            _ => &[],
        }
    }

    fn list_along(&self, terms: &[(Expr, Number)]) -> Map<Symbol, Vec<u32>> {
        let mut lists: Map<Symbol, Vec<u32>> = Map::default();
        for (&(term, _), index) in terms.iter().zip(0..) {
            for symbol in self.directions([term]) {
                lists.entry(symbol).or_default().push(index);
            }
        }
        lists
    }
}
