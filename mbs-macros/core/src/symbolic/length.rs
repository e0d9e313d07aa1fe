//! How many operations expressions have between them, before they are made into a program.

use super::{Expr, Graph, Map, Node, Number};

/// Counts expressions as they come: what several have in common counts once, and what depends on parameters alone not at
/// all.
#[derive(Debug, Default)]
pub struct Length {
    /// The nodes counted so far, and whether they vary.
    seen: Map<Expr, bool>,
    operations: usize,
}

impl Length {
    /// The operations of some expressions.
    pub fn of<'e>(graph: &Graph, exprs: impl IntoIterator<Item = &'e Expr>) -> usize {
        let mut length = Length::default();
        exprs.into_iter().for_each(|&expr| length.add(graph, expr));
        length.operations()
    }

    /// Counts one more expression.
    pub fn add(&mut self, graph: &Graph, expr: Expr) {
        self.varies(graph, expr);
    }

    /// The operations of all expressions so far.
    pub fn operations(&self) -> usize {
        self.operations
    }

    fn varies(&mut self, graph: &Graph, expr: Expr) -> bool {
        if let Some(&known) = self.seen.get(&expr) {
            return known;
        }
        let mut operands = 0;
        graph.for_each_operand(expr, |operand| {
            operands += usize::from(self.varies(graph, operand));
        });
        let (varies, operations) = match graph.node(expr) {
            Node::Constant(_) => (false, 0),
            Node::Symbol(symbol) => (!symbol.is_parameter_like(), 0),
            Node::Law { .. } => (true, 1),
            _ if operands == 0 => (false, 0),
            Node::Sum { constant, terms } => {
                let scaled = terms.iter().filter(|(_, c)| c.value().abs() != 1.0).count();
                let more = *constant != Number::ZERO || terms.len() > operands;
                (true, operands - 1 + scaled.min(1) + usize::from(more))
            }
            Node::Product(factors) => {
                let known = usize::from(factors.len() > operands);
                (true, operands - 1 + known)
            }
            _ => (true, 1),
        };
        self.seen.insert(expr, varies);
        self.operations += operations;
        varies
    }
}
