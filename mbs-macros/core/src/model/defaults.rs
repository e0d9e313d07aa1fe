//! Expressions of parameters as numbers: with the defaults of all parameters, or with others near them.

use super::quantities::Quantity;
use super::resolver::Resolver;
use crate::symbolic::{Evaluator, Expr, Graph, Symbol};

impl Resolver<'_> {
    /// Zero, if an expression of parameters is zero except for rounding, for all of their values.
    pub(super) fn settled(&mut self, expr: Expr) -> Expr {
        match vanishes(&self.graph, &self.parameters, expr, 1e-12) {
            true => self.graph.zero(),
            false => expr,
        }
    }

    /// The value with the defaults of all parameters; NaN if it depends on anything else.
    pub(super) fn by_default(&self, expr: Expr) -> f64 {
        by_default(&self.graph, &self.parameters, expr)
    }
}

/// The value with the defaults of all parameters; NaN if it depends on anything else.
pub(crate) fn by_default(graph: &Graph, parameters: &[Quantity], expr: Expr) -> f64 {
    at_parameters(graph, expr, |index| parameters[index].default)
}

/// Whether an expression of parameters is zero except for rounding, for all of their values.
pub(crate) fn vanishes(graph: &Graph, parameters: &[Quantity], expr: Expr, rounding: f64) -> bool {
    let samples = [(1.0, 0.0), (1.1, 0.013), (0.8, 0.029)];
    samples.into_iter().all(|(factor, shift)| {
        let value = at_parameters(graph, expr, |index| {
            factor * parameters[index].default + shift
        });
        value.abs() < rounding
    })
}

fn at_parameters(graph: &Graph, expr: Expr, parameter: impl Fn(usize) -> f64) -> f64 {
    let symbols = |symbol| match symbol {
        Symbol::Parameter(index) => parameter(index as usize),
        _ => f64::NAN,
    };
    let laws = |_, arguments: &[f64]| (f64::NAN, vec![f64::NAN; arguments.len()]);
    Evaluator::new(graph, &symbols, &laws).value(expr)
}
