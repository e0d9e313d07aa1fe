//! Rates along the motion by the forward mode: for the price of a few times the expressions, however many coordinates
//! there are.

use super::{Expr, Graph, Map, Node, Symbol};

impl Graph {
    /// d/dt of each expression at constant generalized velocities.
    pub fn rates_at_constant_velocity(&mut self, exprs: &[Expr]) -> Vec<Expr> {
        let mut rates: Map<Expr, Expr> = Map::default();
        for node in self.inside(exprs.iter().copied()) {
            let rate = match *self.node(node) {
                Node::Symbol(symbol) => self.symbol_rate(node, symbol),
                _ => {
                    let mut terms = Vec::new();
                    for (operand, partial) in self.partials(node) {
                        let inner = rates[&operand];
                        if !self.is_zero(inner) {
                            terms.push(self.mul(partial, inner));
                        }
                    }
                    self.sum(terms)
                }
            };
            rates.insert(node, rate);
        }
        exprs.iter().map(|expr| rates[expr]).collect()
    }

    fn symbol_rate(&mut self, node: Expr, symbol: Symbol) -> Expr {
        let mut terms = Vec::new();
        for direction in symbol.directions() {
            let rate = match direction {
                Symbol::Time => self.one(),
                Symbol::Coordinate(i) => self.symbol(Symbol::Velocity(i)),
                _ => continue,
            };
            let slope = self.derivative(node, direction);
            terms.push(self.mul(slope, rate));
        }
        self.sum(terms)
    }
}
