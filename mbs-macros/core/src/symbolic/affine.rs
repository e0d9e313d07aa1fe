//! Affine expressions, and the exact elimination of unknowns from systems of them.
//!
//! The unknowns are local positions; their coefficients depend on parameters at most. Each row has the symbol of its
//! multiplier as its residual, so that the solution also contains the derivatives with respect to the residuals; from
//! these the multipliers of eliminated rows are computed.

use super::{Expr, Graph, Map, Node, Symbol};
use std::collections::BTreeMap;

/// constant + Σ coefficient · symbol.
#[derive(Debug, Clone, PartialEq)]
pub struct Affine {
    /// In parameters.
    pub constant: Expr,
    /// Coefficients, those of unknowns in parameters; none is structurally zero.
    pub terms: BTreeMap<Symbol, Expr>,
}

impl Affine {
    pub(crate) fn constant(constant: Expr) -> Affine {
        let terms = BTreeMap::new();
        Affine { constant, terms }
    }

    /// Whether an unknown occurs.
    pub fn has_unknowns(&self) -> bool {
        self.terms.keys().any(|symbol| symbol.is_local_position())
    }

    /// The names of the rows whose residuals occur.
    pub fn residuals(&self) -> impl Iterator<Item = usize> {
        self.terms.keys().filter_map(|symbol| match symbol {
            Symbol::Multiplier(row) => Some(*row as usize),
            _ => None,
        })
    }

    /// self + factor · other
    pub(crate) fn add(&mut self, graph: &mut Graph, factor: Expr, other: &Affine) {
        let constant = graph.mul(factor, other.constant);
        self.constant = graph.add(self.constant, constant);
        for (&symbol, &coefficient) in &other.terms {
            let change = graph.mul(factor, coefficient);
            let before = self.terms.remove(&symbol);
            let sum = before.map_or(change, |before| graph.add(before, change));
            if !graph.is_zero(sum) {
                self.terms.insert(symbol, sum);
            }
        }
    }

    /// Puts the value of an unknown in its place.
    fn replace(&mut self, graph: &mut Graph, unknown: Symbol, value: &Affine) {
        if let Some(coefficient) = self.terms.remove(&unknown) {
            self.add(graph, coefficient, value);
        }
    }
}

/// Reads expressions as affine ones; what it has read it remembers.
#[derive(Debug, Default)]
pub struct AffineReader {
    known: Map<Expr, Option<Affine>>,
}

impl AffineReader {
    /// The expression as an affine one in local positions; `None` where its form is another, or a coefficient depends on
    /// more than parameters.
    pub fn read(&mut self, graph: &mut Graph, expr: Expr) -> Option<Affine> {
        if let Some(known) = self.known.get(&expr) {
            return known.clone();
        }
        let affine = self.form(graph, expr);
        self.known.insert(expr, affine.clone());
        affine
    }

    fn form(&mut self, graph: &mut Graph, expr: Expr) -> Option<Affine> {
        match graph.node(expr).clone() {
            Node::Constant(_) | Node::Symbol(Symbol::Parameter(_)) => Some(Affine::constant(expr)),
            Node::Symbol(symbol @ Symbol::LocalPosition(_)) => {
                let terms = [(symbol, graph.one())].into();
                let constant = graph.zero();
                Some(Affine { constant, terms })
            }
            Node::Symbol(_) | Node::Law { .. } => None,
            Node::Sum { constant, terms } => {
                let mut sum = Affine::constant(graph.constant(constant.value()));
                for &(term, factor) in &terms {
                    let term = self.read(graph, term)?;
                    let factor = graph.constant(factor.value());
                    sum.add(graph, factor, &term);
                }
                Some(sum)
            }
            Node::Product(factors) => {
                let mut moving: Option<Affine> = None;
                let mut rest = Vec::new();
                for &(factor, power) in &factors {
                    let affine = self.read(graph, factor)?;
                    match affine.terms.is_empty() {
                        true => rest.push((factor, power)),
                        false if power == 1 && moving.is_none() => moving = Some(affine),
                        false => return None,
                    }
                }
                let Some(moving) = moving else {
                    return Some(Affine::constant(expr));
                };
                let factor = graph.product(&rest);
                let mut product = Affine::constant(graph.zero());
                product.add(graph, factor, &moving);
                Some(product)
            }
            Node::Function(_, x) | Node::Power(x, _) | Node::Table { x, .. } => {
                let still = self.read(graph, x)?.terms.is_empty();
                still.then(|| Affine::constant(expr))
            }
            Node::Atan2(y, x) | Node::Larger(y, x) => {
                let still =
                    self.read(graph, y)?.terms.is_empty() && self.read(graph, x)?.terms.is_empty();
                still.then(|| Affine::constant(expr))
            }
        }
    }
}

/// Unknowns in terms of those that remain.
#[derive(Debug, Default)]
pub struct Elimination {
    /// The rows that were solved, each with its unknown.
    pub pivots: Vec<(usize, Symbol)>,
    /// The unknowns in terms of those that remain, and of the residuals of the rows.
    pub values: BTreeMap<Symbol, Affine>,
    /// Rows without a pivot: each with the rows on which it depends.
    pub dependent: Vec<Vec<usize>>,
}

/// Gauss–Jordan elimination of as many rows = 0 as have a pivot, each with a number as its name. Divisors are numbers
/// only, so that no division fails for any parameters; a row whose coefficients all depend on parameters is not
/// eliminated.
///
/// The pivot is a coefficient ±1 if there is one, else the largest number, and of several the last. `vanishes` tells a
/// coefficient that is zero except for rounding.
pub fn eliminate(
    graph: &mut Graph,
    rows: &[(usize, Affine)],
    vanishes: impl Fn(&Graph, Expr) -> bool,
) -> Elimination {
    let mut done = Elimination::default();
    for (name, row) in rows {
        let mut row = row.clone();
        let minus_one = graph.constant(-1.0);
        row.terms
            .insert(Symbol::Multiplier(*name as u32), minus_one);
        for (&unknown, value) in &done.values {
            row.replace(graph, unknown, value);
        }
        let unknowns = row.terms.iter().filter(|(s, _)| s.is_local_position());
        let live: Vec<(Symbol, Expr)> = unknowns
            .map(|(&symbol, &coefficient)| (symbol, coefficient))
            .filter(|&(_, coefficient)| !vanishes(graph, coefficient))
            .collect();
        if live.is_empty() {
            done.dependent.push(row.residuals().collect());
            continue;
        }
        let rank = |size: f64| if size == 1.0 { f64::INFINITY } else { size };
        let numbers = live
            .iter()
            .filter_map(|&(symbol, coefficient)| Some((symbol, graph.as_constant(coefficient)?)));
        let pivot = numbers.max_by(|(_, a), (_, b)| rank(a.abs()).total_cmp(&rank(b.abs())));
        let Some((unknown, coefficient)) = pivot else {
            continue;
        };
        row.terms.remove(&unknown);
        let mut value = Affine::constant(graph.zero());
        let factor = graph.constant(-1.0 / coefficient);
        value.add(graph, factor, &row);
        for known in done.values.values_mut() {
            known.replace(graph, unknown, &value);
        }
        done.values.insert(unknown, value);
        done.pivots.push((*name, unknown));
    }
    done
}
