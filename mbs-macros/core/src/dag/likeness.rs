//! Sums that are the same but for their bodies and numbers: those of the legs of a platform, for example.
//!
//! k x + k y is computed as k (x + y), and −k x as a subtraction. Which numbers of a leg are equal, and which are
//! negative, depends on its direction; operations chosen by the numbers of each leg alone would differ from leg to leg,
//! and each would need code of its own. Here all sums of a kind agree.

use super::parts::{EMPTY, Labels, Sets};
use crate::symbolic::{Expr, Graph, Map, Node, Number, Symbol, hash, is_simple};

/// How the sums of each kind are lowered.
#[derive(Debug)]
pub(super) struct Likeness {
    /// The kind of each expression.
    kinds: Vec<u64>,
    /// The parts and joints that each expression depends on.
    owners: Vec<u32>,
    /// By kind, for those with several sums.
    forms: Map<u64, Vec<Slot>>,
}

/// A term of all sums of a kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slot {
    /// The first term whose coefficient is the same or the opposite in each of the sums.
    pub first: usize,
    /// Whether it is the opposite.
    pub opposite: bool,
    /// Whether the coefficient has the same sign in all sums.
    pub has_sign: bool,
}

impl Likeness {
    pub(super) fn of(graph: &Graph, labels: &Labels) -> Likeness {
        let mut likeness = Likeness {
            kinds: Vec::with_capacity(graph.len()),
            owners: owners(graph, labels),
            forms: Map::default(),
        };
        let mut sums: Map<u64, Vec<Vec<f64>>> = Map::default();
        for expr in graph.all() {
            let kind = kind(graph, expr, &likeness.kinds);
            likeness.kinds.push(kind);
            if let Node::Sum { terms, .. } = graph.node(expr) {
                for part in likeness.parts(terms) {
                    let coefficients = part.iter().map(|(_, c)| c.value()).collect();
                    let kind = likeness.kind(&part);
                    sums.entry(kind).or_default().push(coefficients);
                }
            }
        }
        let several = sums.into_iter().filter(|(_, sums)| sums.len() > 1);
        likeness.forms = several.map(|(kind, sums)| (kind, form(&sums))).collect();
        likeness
    }

    /// Terms that depend on the same parts and joints are added up first, because the same terms may be in other sums,
    /// too: those of a bushing are in the sums of both its bodies.
    pub(super) fn parts(&self, terms: &[(Expr, Number)]) -> Vec<Vec<(Expr, Number)>> {
        let mut parts: Vec<(u32, Vec<(Expr, Number)>)> = Vec::new();
        for &(term, coefficient) in terms {
            let owner = self.owners.get(term.index()).copied().unwrap_or(EMPTY);
            match parts.iter_mut().find(|(other, _)| *other == owner) {
                Some((_, part)) => part.push((term, coefficient)),
                None => parts.push((owner, vec![(term, coefficient)])),
            }
        }
        parts.into_iter().map(|(_, part)| part).collect()
    }

    /// The form of a sum, unless it is the only one of its kind.
    pub(super) fn form(&self, terms: &[(Expr, Number)]) -> Option<&[Slot]> {
        let is_known = |&(term, _): &(Expr, Number)| term.index() < self.kinds.len();
        if !terms.iter().all(is_known) {
            return None;
        }
        self.forms.get(&self.kind(terms)).map(Vec::as_slice)
    }

    fn kind(&self, terms: &[(Expr, Number)]) -> u64 {
        let kind = |&(term, c): &(Expr, Number)| (self.kinds[term.index()], number(c));
        terms.iter().fold(0, |all, term| hash((all, kind(term))))
    }
}

/// For each expression the set of labels of its symbols.
fn owners(graph: &Graph, labels: &Labels) -> Vec<u32> {
    let mut sets = Sets::default();
    let mut owners: Vec<u32> = Vec::with_capacity(graph.len());
    for expr in graph.all() {
        let mut own = match graph.node(expr) {
            Node::Symbol(symbol) => sets.of_label(labels.of_symbol(*symbol)),
            _ => EMPTY,
        };
        graph.for_each_operand(expr, |operand| {
            own = sets.union(own, owners[operand.index()]);
        });
        owners.push(own);
    }
    owners
}

/// A hash of an expression without what differs between bodies: numbers, unless they are simple, and indices.
fn kind(graph: &Graph, expr: Expr, kinds: &[u64]) -> u64 {
    let of = |expr: Expr| kinds[expr.index()];
    match graph.node(expr) {
        Node::Constant(value) => hash((0, number(*value))),
        Node::Symbol(symbol) => {
            let entry = match symbol {
                Symbol::Rotation(_, entry) | Symbol::LocalRotation(_, entry) => *entry,
                _ => 0,
            };
            hash((1, std::mem::discriminant(symbol), entry))
        }
        Node::Sum { constant, terms } => {
            let terms = terms.iter();
            let seed = hash((2, number(*constant)));
            terms.fold(seed, |all, &(term, c)| hash((all, of(term), number(c))))
        }
        Node::Product(factors) => {
            let factors = factors.iter();
            factors.fold(3, |all, &(factor, power)| {
                hash((all, of(factor), power as u64))
            })
        }
        Node::Function(function, x) => hash((4, *function as u64, of(*x))),
        Node::Atan2(y, x) => hash((5, of(*y), of(*x))),
        Node::Power(x, exponent) => hash((6, exponent, of(*x))),
        Node::Law {
            law,
            partial,
            arguments,
        } => {
            let seed = hash((7, law, partial));
            arguments.iter().fold(seed, |all, &x| hash((all, of(x))))
        }
        Node::Table { table, order, x } => hash((8, table.index, order, of(*x))),
    }
}

/// A number as part of a kind.
fn number(number: Number) -> Option<Number> {
    is_simple(number.value()).then_some(number)
}

/// Terms are of one group if their coefficients have the same magnitude in each sum, and the same relation of signs.
fn form(sums: &[Vec<f64>]) -> Vec<Slot> {
    let mut firsts: Map<u64, usize> = Map::default();
    let mut slots = Vec::with_capacity(sums[0].len());
    for at in 0..sums[0].len() {
        let is_negative = |sum: &Vec<f64>, at: usize| sum[at] < 0.0;
        let sign = is_negative(&sums[0], at);
        let key = sums.iter().fold(0, |key, sum| {
            let magnitude = Number::new(sum[at].abs());
            hash((key, magnitude, is_negative(sum, at) == sign))
        });
        let first = *firsts.entry(key).or_insert(at);
        slots.push(Slot {
            first,
            opposite: is_negative(&sums[0], first) != sign,
            has_sign: sums.iter().all(|sum| is_negative(sum, at) == sign),
        });
    }
    slots
}
