//! Derivatives, memoised per node and symbol.
//!
//! Orientations are differentiated along the three angular velocities in body axes, D R = R ê, never along components of
//! a quaternion: a derivative of an entry of R is another entry of R or zero, and costs nothing.

use super::{Expr, Function, Graph, Node, Symbol};

impl Graph {
    /// ∂expr/∂symbol.
    pub fn derivative(&mut self, expr: Expr, symbol: Symbol) -> Expr {
        if !self.may_depend_on(expr, symbol) {
            return self.zero();
        }
        if let Node::Symbol(own) = *self.node(expr) {
            return self.symbol_derivative(own, symbol);
        }
        if let Some(&known) = self.derivatives.get(&(expr, symbol)) {
            return known;
        }
        let result = match self.node(expr) {
            // Its terms are many where it is an energy.
            Node::Sum { .. } => self.sum_rule(expr, symbol),
            node => {
                let node = node.clone();
                self.rule(expr, node, symbol)
            }
        };
        self.derivatives.insert((expr, symbol), result);
        result
    }

    fn sum_rule(&mut self, sum: Expr, symbol: Symbol) -> Expr {
        let terms = self.terms_along(sum, symbol).into_iter();
        let terms: Vec<_> = terms
            .map(|(term, coefficient)| (self.derivative(term, symbol), coefficient.value()))
            .collect();
        self.linear(0.0, &terms)
    }

    fn rule(&mut self, expr: Expr, node: Node, symbol: Symbol) -> Expr {
        match node {
            Node::Constant(_) => self.zero(),
            Node::Symbol(own) => self.symbol_derivative(own, symbol),
            Node::Sum { .. } => self.sum_rule(expr, symbol),
            Node::Product(factors) => self.product_rule(&factors, symbol),
            Node::Function(function, x) => {
                let inner = self.derivative(x, symbol);
                if self.is_zero(inner) {
                    inner
                } else {
                    self.chain_rule(function, expr, x, inner)
                }
            }
            Node::Power(x, exponent) => {
                let inner = self.derivative(x, symbol);
                if self.is_zero(inner) {
                    return inner;
                }
                let exponent = exponent.value();
                let outer = self.lowered_power(expr, x, exponent);
                let product = self.mul(outer, inner);
                self.scale(exponent, product)
            }
            Node::Atan2(y, x) => {
                // d atan2(y, x) = (x dy − y dx) / (x² + y²)
                let (dy, dx) = (self.derivative(y, symbol), self.derivative(x, symbol));
                let (first, second) = (self.mul(x, dy), self.mul(y, dx));
                let numerator = self.sub(first, second);
                let (xx, yy) = (self.square(x), self.square(y));
                let denominator = self.add(xx, yy);
                self.div(numerator, denominator)
            }
            Node::Larger(a, b) => {
                let (da, db) = (self.derivative(a, symbol), self.derivative(b, symbol));
                if da == db {
                    return da;
                }
                let by_a = self.first_is_larger(a, b);
                let one = self.one();
                let by_b = self.sub(one, by_a);
                let (first, second) = (self.mul(by_a, da), self.mul(by_b, db));
                self.add(first, second)
            }
            Node::Law {
                law,
                partial,
                arguments,
            } => {
                // Laws give first partials only; second ones are not needed, because laws are refused in rows
                // (model::check).
                let mut terms = Vec::new();
                for (slot, &argument) in arguments.iter().enumerate() {
                    let inner = self.derivative(argument, symbol);
                    if self.is_zero(inner) || partial.is_some() {
                        continue;
                    }
                    let outer = self.intern(Node::Law {
                        law,
                        partial: Some(slot as u32),
                        arguments: arguments.clone(),
                    });
                    terms.push(self.mul(outer, inner));
                }
                self.sum(terms)
            }
            Node::Table { table, order, x } => {
                let inner = self.derivative(x, symbol);
                let outer = self.table(&table, order + 1, x);
                self.mul(outer, inner)
            }
        }
    }

    fn symbol_derivative(&mut self, own: Symbol, by: Symbol) -> Expr {
        let entry = |first: u32, entry: u8, direction: u32| {
            let axis = direction.checked_sub(first).filter(|&axis| axis < 3)? as u8;
            turned_entry(entry, axis)
        };
        let turned = match (own, by) {
            (Symbol::LocalRotation(first, e), Symbol::LocalPosition(i)) => {
                entry(first, e, i).map(|(e, sign)| (Symbol::LocalRotation(first, e), sign))
            }
            (Symbol::Rotation(first, e), Symbol::Coordinate(i)) => {
                entry(first, e, i).map(|(e, sign)| (Symbol::Rotation(first, e), sign))
            }
            _ if own == by => return self.one(),
            _ => None,
        };
        match turned {
            Some((symbol, sign)) => {
                let entry = self.symbol(symbol);
                self.scale(sign, entry)
            }
            None => self.zero(),
        }
    }

    fn product_rule(&mut self, factors: &[(Expr, i32)], symbol: Symbol) -> Expr {
        let mut terms = Vec::new();
        for (slot, &(factor, power)) in factors.iter().enumerate() {
            let inner = self.derivative(factor, symbol);
            if self.is_zero(inner) {
                continue;
            }
            let mut rest = factors.to_vec();
            rest[slot].1 -= 1;
            rest.push((inner, 1));
            terms.push((self.product(&rest), f64::from(power)));
        }
        self.linear(0.0, &terms)
    }

    /// The derivative of `value` = function(x), where that of x is `inner`.
    pub(super) fn chain_rule(
        &mut self,
        function: Function,
        value: Expr,
        x: Expr,
        inner: Expr,
    ) -> Expr {
        let one = self.one();
        let outer = match function {
            Function::Sin => self.function(Function::Cos, x),
            Function::Cos => {
                let sin = self.function(Function::Sin, x);
                self.neg(sin)
            }
            Function::Tan => {
                let square = self.square(value);
                self.add(one, square)
            }
            Function::Asin | Function::Acos => {
                let square = self.square(x);
                let inside = self.sub(one, square);
                let root = self.function(Function::Sqrt, inside);
                let inverse = self.div(one, root);
                if function == Function::Asin {
                    inverse
                } else {
                    self.neg(inverse)
                }
            }
            Function::Atan => {
                let square = self.square(x);
                let denominator = self.add(one, square);
                self.div(one, denominator)
            }
            Function::Sqrt => {
                // ½ of a sum of squares' slope loses all its twos.
                let half = self.halved(inner);
                let value = self.function(Function::Nonzero, value);
                return self.div(half, value);
            }
            Function::Exp => value,
            Function::Ln => self.div(one, x),
            Function::Sinh => self.function(Function::Cosh, x),
            Function::Cosh => self.function(Function::Sinh, x),
            Function::Tanh => {
                let square = self.square(value);
                self.sub(one, square)
            }
            Function::Abs => self.function(Function::Sign, x),
            Function::Sign | Function::Step | Function::Round => self.zero(),
            Function::Same | Function::Nonzero => self.one(),
            Function::Apart => return self.function(function, inner),
        };
        self.mul(outer, inner)
    }

    /// d(expr)/dt along the motion: positions change with their velocities, velocities with their accelerations, and
    /// time with 1.
    pub fn rate(&mut self, expr: Expr) -> Expr {
        let mut terms = Vec::new();
        for symbol in self.directions([expr]) {
            let rate = match symbol {
                Symbol::Time => self.one(),
                Symbol::LocalPosition(i) => self.symbol(Symbol::LocalVelocity(i)),
                Symbol::LocalVelocity(i) => self.symbol(Symbol::LocalAcceleration(i)),
                Symbol::Coordinate(i) => self.symbol(Symbol::Velocity(i)),
                Symbol::Velocity(i) => self.symbol(Symbol::Acceleration(i)),
                _ => continue,
            };
            let partial = self.derivative(expr, symbol);
            terms.push(self.mul(partial, rate));
        }
        self.sum(terms)
    }

    /// expr / 2; a sum is halved term by term where that costs no multiplication.
    fn halved(&mut self, expr: Expr) -> Expr {
        match self.node(expr).clone() {
            Node::Sum { constant, terms } if terms.iter().all(|&(_, c)| c.value().abs() != 1.0) => {
                let terms: Vec<_> = terms
                    .iter()
                    .map(|&(term, c)| (term, 0.5 * c.value()))
                    .collect();
                self.linear(0.5 * constant.value(), &terms)
            }
            _ => self.scale(0.5, expr),
        }
    }
}

/// R ê_axis, entry by entry: column j of R ê_k is Σ_i ε_ikj (column i of R). Answers the entry and its sign.
fn turned_entry(entry: u8, axis: u8) -> Option<(u8, f64)> {
    let (row, column) = (entry / 3, entry % 3);
    if column == axis {
        return None;
    }
    let other = 3 - column - axis;
    // (other, axis, column) is an even permutation where `axis` follows `other`.
    let sign = if (other + 1) % 3 == axis { 1.0 } else { -1.0 };
    Some((3 * row + other, sign))
}
