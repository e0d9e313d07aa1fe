//! Expressions that jump or bend.

use super::{Expr, Function, Graph, Node, Number, Symbol};

impl Graph {
    /// Whether a step, or a sign, is added to the rest with a constant factor: the value jumps. (Where an input jumps, the
    /// mechanism follows.)
    pub fn jumps(&self, expr: Expr) -> bool {
        let varies =
            |symbol: Symbol| !symbol.is_parameter_like() && !matches!(symbol, Symbol::Input(_));
        let is_step = |factor: Expr| match self.node(factor) {
            Node::Function(Function::Step | Function::Sign, x) => self.depends_on(*x, varies),
            _ => false,
        };
        let is_constant = |factor: Expr| {
            !self.depends_on(factor, |symbol| !symbol.is_parameter_like())
                && !self.contains_law(factor)
        };
        let term_jumps = |term: Expr| match self.node(term) {
            Node::Product(factors) => {
                let mut factors = factors.iter().map(|&(factor, _)| factor);
                factors.clone().any(is_step) && factors.all(|x| is_step(x) || is_constant(x))
            }
            _ => is_step(term),
        };
        match self.node(expr) {
            Node::Sum { terms, .. } => terms.iter().any(|&(term, _)| term_jumps(term)),
            _ => term_jumps(expr),
        }
    }

    /// Whether a table whose slope jumps occurs in the expression, as a derivative of this order or a higher one.
    pub fn contains_kink(&self, expr: Expr, from: i8) -> bool {
        self.any_inside([expr], |node| {
            matches!(node, Node::Table { table, order, .. } if *order >= from && table.has_kinks())
        })
    }

    /// What has to be smooth so that a row is. A row is zero, and there neither atan2 nor the count of full turns jumps.
    pub fn inside_row(&self, row: Expr) -> Vec<Expr> {
        let is_turns = |term: Expr| matches!(self.node(term), Node::Function(Function::Round, _));
        // A part of a full turn jumps.
        let is_whole = |coefficient: Number| coefficient.value().fract() == 0.0;
        match self.node(row) {
            Node::Atan2(y, x) => vec![*y, *x],
            Node::Function(Function::Apart, sum) => self.inside_row(*sum),
            Node::Sum {
                constant: Number::ZERO,
                terms,
            } if terms.len() == 1 && is_whole(terms[0].1) => self.inside_row(terms[0].0),
            Node::Sum { terms, .. } if terms.iter().any(|&(term, _)| is_turns(term)) => {
                let others = terms.iter().filter(|(term, _)| !is_turns(*term));
                let inside = |&(term, coefficient)| match is_whole(coefficient) {
                    true => self.inside_row(term),
                    false => vec![term],
                };
                others.flat_map(inside).collect()
            }
            _ => vec![row],
        }
    }

    /// Whether expressions consist of sums, products, sines and cosines of what varies within a step. Others may jump or bend, or come
    /// near to it (friction).
    pub fn is_smooth(&self, roots: impl IntoIterator<Item = Expr>) -> bool {
        let varies = |expr: Expr| {
            let is_fixed =
                |symbol: Symbol| symbol.is_parameter_like() || matches!(symbol, Symbol::Input(_));
            self.depends_on(expr, |symbol| !is_fixed(symbol))
        };
        let is_plain = |function| {
            use Function::{Apart, Cos, Same, Sin};
            matches!(function, Sin | Cos | Same | Apart)
        };
        !self.any_inside(roots, |node| match node {
            Node::Constant(_) | Node::Symbol(_) | Node::Sum { .. } => false,
            Node::Product(factors) => {
                let mut divisors = factors.iter().filter(|(_, power)| *power < 0);
                divisors.any(|&(factor, _)| varies(factor))
            }
            Node::Function(function, x) => !is_plain(*function) && varies(*x),
            Node::Power(x, _) | Node::Table { x, .. } => varies(*x),
            Node::Atan2(a, b) | Node::Larger(a, b) => varies(*a) || varies(*b),
            Node::Law { arguments, .. } => arguments.iter().any(|&argument| varies(argument)),
        })
    }
}
