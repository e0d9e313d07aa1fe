//! Gradients by the reverse mode: all derivatives of a scalar cost a few times the scalar, for any number of symbols.
//!
//! Forward derivatives cost as much as the expression, once for each symbol. Where one scalar is differentiated along all
//! coordinates (∂T/∂q of a chain of n bodies), going backwards keeps the cost linear in n.

use super::{Expr, Graph, Map, Node, Set, Symbol};
use std::collections::BTreeMap;

impl Graph {
    /// ∂expr/∂symbol for all directions along which it changes (see [`Graph::directions`]): absent ones are zero.
    pub fn gradient(&mut self, expr: Expr) -> BTreeMap<Symbol, Expr> {
        let order = self.inside([expr]);
        let mut adjoints: Map<Expr, Vec<Expr>> = Map::default();
        let one = self.one();
        adjoints.insert(expr, vec![one]);
        let mut slopes: BTreeMap<Symbol, Vec<Expr>> = BTreeMap::new();
        for &node in order.iter().rev() {
            let Some(terms) = adjoints.get_mut(&node).map(std::mem::take) else {
                continue;
            };
            let adjoint = self.sum(terms);
            if self.is_zero(adjoint) {
                continue;
            }
            if let Node::Symbol(symbol) = *self.node(node) {
                for direction in symbol.directions() {
                    let slope = self.derivative(node, direction);
                    let term = self.mul(adjoint, slope);
                    slopes.entry(direction).or_default().push(term);
                }
                continue;
            }
            for (operand, partial) in self.partials(node) {
                let term = self.mul(adjoint, partial);
                adjoints.entry(operand).or_default().push(term);
            }
        }
        slopes
            .into_iter()
            .map(|(symbol, terms)| (symbol, self.sum(terms)))
            .collect()
    }

    /// The nodes of some expressions, operands first.
    pub(super) fn inside(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Expr> {
        // Operands are made before what is made of them, so that the order of indices will do.
        let mut found = Vec::new();
        let mut seen: Set<Expr> = Set::default();
        let mut stack: Vec<Expr> = roots.into_iter().collect();
        while let Some(next) = stack.pop() {
            if seen.insert(next) {
                found.push(next);
                self.for_each_operand(next, |operand| stack.push(operand));
            }
        }
        found.sort_unstable();
        found
    }

    /// The operands of a node with the derivatives of the node by each.
    pub(super) fn partials(&mut self, expr: Expr) -> Vec<(Expr, Expr)> {
        match self.node(expr).clone() {
            Node::Constant(_) | Node::Symbol(_) => Vec::new(),
            Node::Sum { terms, .. } => terms
                .iter()
                .map(|&(term, coefficient)| (term, self.constant(coefficient.value())))
                .collect(),
            Node::Product(factors) => (0..factors.len())
                .map(|slot| {
                    let (factor, power) = factors[slot];
                    let mut rest = factors.to_vec();
                    rest[slot].1 -= 1;
                    let rest = self.product(&rest);
                    (factor, self.scale(f64::from(power), rest))
                })
                .collect(),
            Node::Function(function, x) => {
                let one = self.one();
                vec![(x, self.chain_rule(function, expr, x, one))]
            }
            Node::Power(x, exponent) => {
                let outer = self.lowered_power(expr, x, exponent.value());
                vec![(x, self.scale(exponent.value(), outer))]
            }
            Node::Atan2(y, x) => {
                let (xx, yy) = (self.square(x), self.square(y));
                let square = self.add(xx, yy);
                let (by_y, by_x) = (self.div(x, square), self.div(y, square));
                vec![(y, by_y), (x, self.neg(by_x))]
            }
            Node::Larger(a, b) => {
                let by_a = self.first_is_larger(a, b);
                let one = self.one();
                vec![(a, by_a), (b, self.sub(one, by_a))]
            }
            Node::Law {
                law,
                partial,
                arguments,
            } => (0..arguments.len())
                // Laws supply first partials only.
                .filter(|_| partial.is_none())
                .map(|slot| {
                    let node = Node::Law {
                        law,
                        partial: Some(slot as u32),
                        arguments: arguments.clone(),
                    };
                    (arguments[slot], self.intern(node))
                })
                .collect(),
            Node::Table { table, order, x } => vec![(x, self.table(&table, order + 1, x))],
        }
    }
}
