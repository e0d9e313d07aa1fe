//! The value of expressions in the home pose.

use super::guesses::Guesses;
use crate::model::resolver::Resolver;
use crate::symbolic::{Evaluator, Expr, Symbol};
use std::collections::HashMap;

impl Resolver<'_> {
    /// The value of an expression in local coordinates in the home pose, with the defaults of all parameters, at t = 0.
    pub(in crate::model) fn at_home(&mut self, expr: Expr, guesses: &Guesses) -> f64 {
        let mut values: HashMap<Symbol, f64> = HashMap::new();
        for symbol in self.graph.symbols([expr]) {
            let known = match symbol {
                Symbol::LocalPosition(local) => guesses.position(local, &mut self.graph),
                Symbol::LocalRotation(first, entry) => match self.home_rotation(first, entry) {
                    Some(known) => known,
                    None => continue,
                },
                Symbol::Parameter(_) => self.graph.symbol(symbol),
                _ => self.graph.zero(),
            };
            values.insert(symbol, self.by_default(known));
        }
        let symbols = |symbol| values.get(&symbol).copied().unwrap_or(f64::NAN);
        let laws = |_, arguments: &[f64]| (f64::NAN, vec![f64::NAN; arguments.len()]);
        Evaluator::new(&self.graph, &symbols, &laws).value(expr)
    }
}
