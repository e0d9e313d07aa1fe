//! The interpreter: numbers for symbols. Slow and simple; tests compare generated code with it.

use super::{Expr, Function, Graph, Map, Node, Symbol};

impl Function {
    /// The function's value.
    pub fn evaluate(self, x: f64) -> f64 {
        match self {
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Asin => x.asin(),
            Function::Acos => x.acos(),
            Function::Atan => x.atan(),
            Function::Sqrt => x.sqrt(),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Sinh => x.sinh(),
            Function::Cosh => x.cosh(),
            Function::Tanh => x.tanh(),
            Function::Abs => x.abs(),
            Function::Round => x.round(),
            Function::Nonzero => {
                if x < 1e-40 {
                    1e-40
                } else {
                    x
                }
            }
            Function::Same | Function::Apart => x,
            Function::Sign => {
                if x == 0.0 {
                    0.0
                } else {
                    x.signum()
                }
            }
            Function::Step => {
                if x > 0.0 {
                    1.0
                } else {
                    0.0
                }
            }
        }
    }
}

/// The larger of two values, as generated code computes it: not a number where one of them is not.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// A law for the interpreter: value and partials for the arguments given.
pub type LawEvaluation<'a> = &'a dyn Fn(u32, &[f64]) -> (f64, Vec<f64>);

/// Evaluates expressions of a graph for given values of the symbols.
pub struct Evaluator<'a> {
    graph: &'a Graph,
    symbols: &'a dyn Fn(Symbol) -> f64,
    laws: LawEvaluation<'a>,
    done: Map<Expr, f64>,
}

impl<'a> Evaluator<'a> {
    /// An evaluator; `symbols` gives the value of each symbol, `laws` evaluates the user's laws.
    pub fn new(
        graph: &'a Graph,
        symbols: &'a dyn Fn(Symbol) -> f64,
        laws: LawEvaluation<'a>,
    ) -> Self {
        Evaluator {
            graph,
            symbols,
            laws,
            done: Map::default(),
        }
    }

    /// The value of an expression.
    pub fn value(&mut self, expr: Expr) -> f64 {
        if let Some(&known) = self.done.get(&expr) {
            return known;
        }
        let result = match self.graph.node(expr) {
            Node::Constant(number) => number.value(),
            Node::Symbol(symbol) => (self.symbols)(*symbol),
            Node::Sum { constant, terms } => {
                terms.iter().fold(constant.value(), |sum, &(term, c)| {
                    sum + c.value() * self.value(term)
                })
            }
            Node::Product(factors) => factors.iter().fold(1.0, |product, &(factor, power)| {
                product * self.value(factor).powi(power)
            }),
            Node::Function(function, x) => function.evaluate(self.value(*x)),
            Node::Power(x, exponent) => self.value(*x).powf(exponent.value()),
            Node::Atan2(y, x) => self.value(*y).atan2(self.value(*x)),
            Node::Larger(a, b) => larger(self.value(*a), self.value(*b)),
            Node::Law {
                law,
                partial,
                arguments,
            } => {
                let arguments: Vec<f64> = arguments.iter().map(|&x| self.value(x)).collect();
                let (value, partials) = (self.laws)(*law, &arguments);
                partial.map_or(value, |slot| partials[slot as usize])
            }
            Node::Table { table, order, x } => table.value(self.value(*x), *order),
        };
        self.done.insert(expr, result);
        result
    }
}
