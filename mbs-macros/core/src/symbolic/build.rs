//! Constructors: every node is made here, in canonical form.

use super::collected::{Total, are_multiplied, collect, put_factor};
use super::{Expr, Function, Graph, Node, Number, Symbol, larger, reach_of};

/// A sum of more terms is not flattened into another: one that grows name by name would be copied for each name.
const LONG_SUM: usize = 512;

impl Graph {
    pub(super) fn intern(&mut self, node: Node) -> Expr {
        let hash = node.hashed();
        if let Some(known) = self.known(&node, hash) {
            return known;
        }
        let expr = Expr(self.nodes.len() as u32);
        let mut reach = match node {
            Node::Symbol(symbol) => reach_of(symbol),
            _ => 0,
        };
        self.nodes.push(node);
        self.index.insert(expr.0, hash);
        let mut levels = 0;
        self.for_each_operand(expr, |operand| {
            reach |= self.reach[operand.0 as usize];
            levels = levels.max(self.levels[operand.0 as usize] + 1);
        });
        self.reach.push(reach);
        self.levels.push(levels);
        expr
    }

    /// The expression of a node with this hash, if it was made already.
    fn known(&self, node: &Node, hash: u32) -> Option<Expr> {
        let is_it = |number: u32| self.nodes[number as usize] == *node;
        self.index.find(hash, is_it).map(Expr)
    }

    /// A number.
    pub fn constant(&mut self, value: f64) -> Expr {
        self.intern(Node::Constant(Number::new(value)))
    }

    /// Zero.
    pub fn zero(&mut self) -> Expr {
        if let Some(zero) = self.zero {
            return zero;
        }
        let zero = self.constant(0.0);
        self.zero = Some(zero);
        zero
    }

    /// One.
    pub fn one(&mut self) -> Expr {
        self.constant(1.0)
    }

    /// A symbol.
    pub fn symbol(&mut self, symbol: Symbol) -> Expr {
        self.intern(Node::Symbol(symbol))
    }

    /// a + b.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        self.linear(0.0, &[(a, 1.0), (b, 1.0)])
    }

    /// a − b.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        self.linear(0.0, &[(a, 1.0), (b, -1.0)])
    }

    /// −a.
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.linear(0.0, &[(a, -1.0)])
    }

    /// factor · a.
    pub fn scale(&mut self, factor: f64, a: Expr) -> Expr {
        self.linear(0.0, &[(a, factor)])
    }

    /// The sum of all.
    pub fn sum(&mut self, terms: impl IntoIterator<Item = Expr>) -> Expr {
        let terms = terms.into_iter().filter(|&term| !self.is_zero(term));
        let terms: Vec<_> = terms.map(|term| (term, 1.0)).collect();
        match terms.as_slice() {
            [(term, _)] => *term,
            terms => self.linear(0.0, terms),
        }
    }

    /// constant + Σ coefficient · term.
    pub fn linear(&mut self, constant: f64, terms: &[(Expr, f64)]) -> Expr {
        let mut constant = Total::of(constant);
        let mut flat: Vec<(Expr, f64)> = Vec::with_capacity(terms.len());
        for &(term, coefficient) in terms {
            self.flatten_term(term, coefficient, &mut constant, &mut flat);
        }
        collect(&mut flat);
        self.pythagoras(&mut flat, &mut constant);
        // 3 (x + y) − 2 (x + y) becomes x + y: a coefficient may be ±1 only after the terms were collected.
        while self.any_dissolves(&flat) {
            for (term, coefficient) in std::mem::take(&mut flat) {
                self.flatten_term(term, coefficient, &mut constant, &mut flat);
            }
            collect(&mut flat);
            self.pythagoras(&mut flat, &mut constant);
        }
        let constant = constant.value();
        match flat.as_slice() {
            [] => return self.constant(constant),
            [(term, 1.0)] if constant == 0.0 => return *term,
            _ => {}
        }
        let sign = self.sign(&flat, constant);
        let negative = sign < 0.0;
        let sum = self.intern(Node::Sum {
            constant: Number::new(sign * constant),
            terms: scaled(&flat, sign),
        });
        if negative {
            self.intern(Node::Sum {
                constant: Number::ZERO,
                terms: [(sum, Number::new(-1.0))].into(),
            })
        } else {
            sum
        }
    }

    /// The sign with which a sum is stored: a − b and b − a share a node.
    ///
    /// In a proper sum most coefficients are positive, and the first where as many are negative; the negative of such a
    /// sum is a scaled term. For coefficients that count see [`Graph::of_many`].
    fn sign(&self, terms: &[(Expr, f64)], constant: f64) -> f64 {
        if terms.len() == 1 {
            return 1.0;
        }
        let (mut counted, mut minus, mut first) = (0, 0, None);
        for &(_, coefficient) in terms {
            if !self.of_many || is_simple(coefficient) {
                let is_negative = coefficient < 0.0;
                counted += 1;
                minus += usize::from(is_negative);
                first = first.or(Some(is_negative));
            }
        }
        let negative = match first {
            Some(first) => 2 * minus > counted || (2 * minus == counted && first),
            None => {
                let opposite = Node::Sum {
                    constant: Number::new(-constant),
                    terms: scaled(terms, -1.0),
                };
                self.known(&opposite, opposite.hashed()).is_some()
            }
        };
        if negative { -1.0 } else { 1.0 }
    }

    /// Whether one of the terms of a sum is a sum to be dissolved.
    fn any_dissolves(&self, flat: &[(Expr, f64)]) -> bool {
        let mut at = 0;
        while at < flat.len() {
            let (term, coefficient) = flat[at];
            if let Node::Sum { terms, .. } = self.node(term)
                && coefficient.abs() == 1.0
                && terms.len() <= LONG_SUM
            {
                return true;
            }
            at += 1;
        }
        false
    }

    /// A nested sum is flattened if this needs no multiplication, coefficient ±1 or a single scaled term, and if it is
    /// not long.
    fn flatten_term(
        &mut self,
        term: Expr,
        coefficient: f64,
        constant: &mut Total,
        flat: &mut Vec<(Expr, f64)>,
    ) {
        if coefficient == 0.0 {
            return;
        }
        match self.node(term) {
            Node::Constant(number) => constant.add(coefficient * number.value()),
            Node::Sum {
                constant: inner,
                terms,
            } if terms.len() == 1 => {
                constant.add(coefficient * inner.value());
                let (term, own) = terms[0];
                self.flatten_term(term, coefficient * own.value(), constant, flat);
            }
            Node::Sum {
                constant: inner,
                terms,
            } if coefficient.abs() == 1.0 && terms.len() <= LONG_SUM => {
                constant.add(coefficient * inner.value());
                for &(term, own) in terms {
                    flat.push((term, coefficient * own.value()));
                }
            }
            _ => flat.push((term, coefficient)),
        }
    }

    /// c·m·sin²x + c·m·cos²x = c·m.
    fn pythagoras(&mut self, terms: &mut Vec<(Expr, f64)>, constant: &mut Total) {
        let mut position = 0;
        while position < terms.len() {
            let (term, coefficient) = terms[position];
            let Some((partner, rest)) = self.cosine_partner(term) else {
                position += 1;
                continue;
            };
            let found = terms
                .iter()
                .position(|&(other, c)| other == partner && c == coefficient);
            let Some(found) = found else {
                position += 1;
                continue;
            };
            terms.swap_remove(position.max(found));
            terms.swap_remove(position.min(found));
            self.flatten_term(rest, coefficient, constant, terms);
            collect(terms);
            position = 0;
        }
    }

    /// For m·sin²x: the terms m·cos²x and m.
    fn cosine_partner(&mut self, term: Expr) -> Option<(Expr, Expr)> {
        let Node::Product(factors) = self.node(term) else {
            return None;
        };
        let mut slot = 0;
        let angle = loop {
            let &(factor, power) = factors.get(slot)?;
            match self.node(factor) {
                Node::Function(Function::Sin, angle) if power >= 2 => break *angle,
                _ => slot += 1,
            }
        };
        let mut rest: Vec<(Expr, i32)> = factors.to_vec();
        rest[slot].1 -= 2;
        let cos = self.function(Function::Cos, angle);
        let mut partner = rest.clone();
        partner.push((cos, 2));
        Some((self.product(&partner), self.product(&rest)))
    }

    /// a · b.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(0.0), None) | (None, Some(1.0)) => return a,
            (None, Some(0.0)) | (Some(1.0), None) => return b,
            _ => {}
        }
        self.product(&[(a, 1), (b, 1)])
    }

    /// a / b.
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        self.product(&[(a, 1), (b, -1)])
    }

    /// a².
    pub fn square(&mut self, a: Expr) -> Expr {
        self.product(&[(a, 2)])
    }

    /// Π factor^power.
    pub fn product(&mut self, factors: &[(Expr, i32)]) -> Expr {
        let mut coefficient = 1.0;
        let mut merged: Vec<(Expr, i32)> = Vec::with_capacity(factors.len() + 2);
        self.flatten_factors(factors, 1, &mut coefficient, &mut merged);
        self.cancel_roots(&mut merged);
        // √x · √x = x
        if let Some(slot) = self.double_root(&merged) {
            let (root, power) = merged[slot];
            let Node::Function(_, inside) = *self.node(root) else {
                unreachable!("matched above")
            };
            merged[slot] = (root, power % 2);
            merged.push((inside, power / 2));
            let product = self.product(&merged);
            return self.scale(coefficient, product);
        }
        if coefficient == 0.0 {
            return self.zero();
        }
        let product = match merged.as_slice() {
            [] => return self.constant(coefficient),
            [(factor, 1)] => *factor,
            _ => self.intern(Node::Product(merged.into())),
        };
        if coefficient == 1.0 {
            product
        } else {
            self.linear(0.0, &[(product, coefficient)])
        }
    }

    /// Puts factors into a sorted list, those of products inside one by one, and multiplies the numbers among them.
    fn flatten_factors(
        &self,
        factors: &[(Expr, i32)],
        exponent: i32,
        coefficient: &mut f64,
        flat: &mut Vec<(Expr, i32)>,
    ) {
        let mut left = factors.len();
        while left > 0 {
            left -= 1;
            let (factor, power) = factors[left];
            let power = power * exponent;
            if power == 0 {
                continue;
            }
            match self.node(factor) {
                Node::Constant(number) => *coefficient *= number.value().powi(power),
                Node::Sum {
                    constant: Number::ZERO,
                    terms,
                } if terms.len() == 1 => {
                    let powered = terms[0].1.value().powi(power);
                    if powered == 0.0 || !powered.is_finite() {
                        // Not the value of the whole.
                        put_factor(flat, factor, power);
                        continue;
                    }
                    *coefficient *= powered;
                    self.flatten_factors(&[(terms[0].0, power)], 1, coefficient, flat);
                }
                Node::Product(inner) if are_multiplied(inner, power) => {
                    self.flatten_factors(inner, power, coefficient, flat);
                }
                _ => put_factor(flat, factor, power),
            }
        }
    }

    /// base^exponent.
    pub fn power(&mut self, base: Expr, exponent: f64) -> Expr {
        if exponent == exponent.trunc() && exponent.abs() < 1e6 {
            return self.product(&[(base, exponent as i32)]);
        }
        if exponent == 0.5 {
            return self.function(Function::Sqrt, base);
        }
        match self.as_constant(base) {
            Some(value) if value >= 0.0 => self.constant(value.powf(exponent)),
            _ => self.intern(Node::Power(base, Number::new(exponent))),
        }
    }

    /// An elementary function.
    pub fn function(&mut self, function: Function, x: Expr) -> Expr {
        if function == Function::Apart {
            return self.apart(x);
        }
        if let Some(value) = self.as_constant(x) {
            let result = function.evaluate(value);
            if result.is_finite() {
                return self.constant(result);
            }
        }
        // Odd and even functions take the sign out, so that sin(−x) and sin(x) share.
        if let Some(positive) = self.without_sign(x) {
            match function {
                Function::Sin
                | Function::Tan
                | Function::Asin
                | Function::Atan
                | Function::Sinh
                | Function::Tanh
                | Function::Sign => {
                    let value = self.function(function, positive);
                    return self.neg(value);
                }
                Function::Cos | Function::Cosh | Function::Abs => {
                    return self.function(function, positive);
                }
                _ => {}
            }
        }
        self.intern(Node::Function(function, x))
    }

    /// A sum that others do not take in; what is no sum remains.
    fn apart(&mut self, x: Expr) -> Expr {
        match self.node(x) {
            Node::Sum {
                constant: Number::ZERO,
                terms,
            } if terms.len() == 1 => {
                let (term, coefficient) = terms[0];
                let term = self.apart(term);
                self.scale(coefficient.value(), term)
            }
            Node::Sum { .. } => self.intern(Node::Function(Function::Apart, x)),
            _ => x,
        }
    }

    /// If `x` is minus something simple, that something.
    fn without_sign(&mut self, x: Expr) -> Option<Expr> {
        let Node::Sum {
            constant: Number::ZERO,
            terms,
        } = self.node(x)
        else {
            return None;
        };
        match **terms {
            [(term, coefficient)] if coefficient.value() < 0.0 => {
                Some(self.scale(-coefficient.value(), term))
            }
            _ => None,
        }
    }

    /// atan2(y, x).
    pub fn atan2(&mut self, y: Expr, x: Expr) -> Expr {
        match (self.as_constant(y), self.as_constant(x)) {
            (Some(y), Some(x)) => self.constant(y.atan2(x)),
            _ => self.intern(Node::Atan2(y, x)),
        }
    }

    /// The larger of two values; not a number where one of them is not.
    pub fn larger(&mut self, a: Expr, b: Expr) -> Expr {
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(a), Some(b)) => self.constant(larger(a, b)),
            _ if a == b => a,
            _ => self.intern(Node::Larger(a, b)),
        }
    }

    /// The smaller of two values.
    pub fn smaller(&mut self, a: Expr, b: Expr) -> Expr {
        let (a, b) = (self.neg(a), self.neg(b));
        let negative = self.larger(a, b);
        self.neg(negative)
    }

    /// 1 where the first of two values is the larger one, and 0 elsewhere.
    pub(super) fn first_is_larger(&mut self, a: Expr, b: Expr) -> Expr {
        let difference = self.sub(a, b);
        self.function(Function::Step, difference)
    }

    /// The value of a user's law.
    pub fn law(&mut self, law: u32, arguments: &[Expr]) -> Expr {
        self.intern(Node::Law {
            law,
            partial: None,
            arguments: arguments.into(),
        })
    }
}

fn scaled(terms: &[(Expr, f64)], factor: f64) -> Box<[(Expr, Number)]> {
    let mut scaled = Vec::with_capacity(terms.len());
    for &(term, coefficient) in terms {
        scaled.push((term, Number::new(factor * coefficient)));
    }
    scaled.into()
}

/// Whether a coefficient is likely to come from a formula, not from a place or direction.
pub(crate) fn is_simple(coefficient: f64) -> bool {
    (4.0 * coefficient).fract() == 0.0
}
