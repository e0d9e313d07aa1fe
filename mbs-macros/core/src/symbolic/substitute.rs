//! Replacement of symbols by expressions.

use super::{Expr, Function, Graph, Map, Node, Number, Symbol};

/// A substitution with its memory, so that many expressions can share the work.
#[derive(Debug, Clone, Default)]
pub struct Substitution {
    map: Map<Symbol, Expr>,
    /// Symbols that stand for a sum of other entries, with its terms.
    sums: Map<Symbol, Vec<(Expr, f64)>>,
    done: Map<Expr, Expr>,
    /// Whether name suggestions stay behind.
    nameless: bool,
}

impl Substitution {
    /// One whose results have no suggested names: they are values at one pose.
    pub fn nameless() -> Self {
        Substitution {
            nameless: true,
            ..Substitution::default()
        }
    }

    /// Replaces `symbol` by `expr` from now on (to be called before the first use).
    pub fn insert(&mut self, symbol: Symbol, expr: Expr) {
        self.map.insert(symbol, expr);
    }

    /// Replaces `symbol` by `sum`, whose terms are entered in sums of this symbol one by one: k (a x + b y) becomes
    /// (k a) x + (k b) y, where k a and k b are numbers.
    pub fn insert_sum(&mut self, symbol: Symbol, sum: Expr, terms: Vec<(Expr, f64)>) {
        self.insert(symbol, sum);
        self.sums.insert(symbol, terms);
    }

    /// Replaces a whole expression from now on (to be called before the first use).
    pub fn equate(&mut self, expr: Expr, value: Expr) {
        self.done.insert(expr, value);
    }

    /// What a symbol is replaced by.
    pub fn get(&self, symbol: Symbol) -> Option<Expr> {
        self.map.get(&symbol).copied()
    }
}

impl Graph {
    /// `expr` with all symbols of the substitution replaced. Name suggestions carry over, unless it is nameless.
    pub fn substitute(&mut self, expr: Expr, substitution: &mut Substitution) -> Expr {
        if let Some(&known) = substitution.done.get(&expr) {
            return known;
        }
        let result = match self.node(expr).clone() {
            Node::Constant(_) => expr,
            Node::Symbol(symbol) => substitution.get(symbol).unwrap_or(expr),
            Node::Sum { constant, terms } => {
                let mut replaced: Vec<(Expr, f64)> = Vec::with_capacity(terms.len());
                for &(x, c) in &terms {
                    match self.sum_of(x, &terms, substitution) {
                        Some(sum) => replaced.extend(sum.iter().map(|&(y, k)| (y, c.value() * k))),
                        None => replaced.push((self.substitute(x, substitution), c.value())),
                    }
                }
                self.linear(constant.value(), &replaced)
            }
            Node::Product(factors) => {
                let factors: Vec<_> = factors
                    .iter()
                    .map(|&(x, p)| (self.substitute(x, substitution), p))
                    .collect();
                self.product(&factors)
            }
            // The mark is not needed any more: see `Substitution::equate`.
            Node::Function(Function::Same, x) => self.substitute(x, substitution),
            Node::Function(function, x) => {
                let x = self.substitute(x, substitution);
                self.function(function, x)
            }
            Node::Power(x, exponent) => {
                let x = self.substitute(x, substitution);
                self.power(x, exponent.value())
            }
            Node::Atan2(y, x) => {
                let (y, x) = (
                    self.substitute(y, substitution),
                    self.substitute(x, substitution),
                );
                self.atan2(y, x)
            }
            Node::Larger(a, b) => {
                let (a, b) = (
                    self.substitute(a, substitution),
                    self.substitute(b, substitution),
                );
                self.larger(a, b)
            }
            Node::Law {
                law,
                partial,
                arguments,
            } => {
                let arguments = arguments
                    .iter()
                    .map(|&x| self.substitute(x, substitution))
                    .collect();
                self.intern(Node::Law {
                    law,
                    partial,
                    arguments,
                })
            }
            Node::Table { table, order, x } => {
                let x = self.substitute(x, substitution);
                self.table(&table, order, x)
            }
        };
        if !substitution.nameless
            && let Some(name) = self.hints.get(&expr).cloned()
            && !matches!(self.node(result), Node::Symbol(_) | Node::Constant(_))
        {
            self.suggest_name(result, name);
        }
        substitution.done.insert(expr, result);
        result
    }

    /// The sum that a symbol stands for, if it is better to enter its terms in another sum: that has a second symbol of the same
    /// row of a rotation, whose sum has the same terms.
    fn sum_of<'a>(
        &self,
        x: Expr,
        terms: &[(Expr, Number)],
        substitution: &'a Substitution,
    ) -> Option<&'a [(Expr, f64)]> {
        let entry = |x: Expr| match *self.node(x) {
            Node::Symbol(Symbol::LocalRotation(first, entry)) => Some((first, entry / 3)),
            _ => None,
        };
        let row = entry(x)?;
        let alike = terms.iter().filter(|(x, _)| entry(*x) == Some(row));
        match *self.node(x) {
            Node::Symbol(symbol) if alike.count() > 1 => {
                substitution.sums.get(&symbol).map(Vec::as_slice)
            }
            _ => None,
        }
    }

    /// Whether an expression is affine in the velocities.
    pub fn is_affine_in_velocities(&mut self, expr: Expr) -> bool {
        // The derivative of a sign is zero wherever it has one.
        let switches = self.any_inside([expr], |node| match node {
            Node::Function(Function::Sign | Function::Step | Function::Round, x) => {
                self.depends_on(*x, Symbol::is_velocity)
            }
            _ => false,
        });
        if switches {
            return false;
        }
        let symbols = self.symbols([expr]).into_iter();
        let velocities: Vec<Symbol> = symbols.filter(|symbol| symbol.is_velocity()).collect();
        velocities.into_iter().all(|velocity| {
            let coefficient = self.derivative(expr, velocity);
            !self.depends_on(coefficient, Symbol::is_velocity)
        })
    }

    /// `expr` where all velocities are zero.
    pub fn without_velocities(&mut self, expr: Expr) -> Expr {
        let zero = self.zero();
        let mut rest = Substitution::default();
        for symbol in self
            .symbols([expr])
            .into_iter()
            .filter(|symbol| symbol.is_velocity())
        {
            rest.insert(symbol, zero);
        }
        self.substitute(expr, &mut rest)
    }
}
