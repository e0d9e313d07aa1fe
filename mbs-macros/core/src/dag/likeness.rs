//! Sums that are the same but for their bodies and numbers: those of the legs of a platform, for example.
//!
//! k x + k y is computed as k (x + y), and −k x as a subtraction. Which numbers of a leg are equal, and which are
//! negative, depends on its direction; operations chosen by the numbers of each leg alone would differ from leg to leg,
//! and each would need code of its own. Here all sums of a kind agree.

use super::parts::{EMPTY, Labels, Sets};
use crate::symbolic::{Expr, Graph, Map, Node, Number, Symbol, hash, is_simple, mixed};
use std::borrow::Cow;

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
        let mut sums: Map<u64, Sums> = Map::default();
        for expr in graph.all() {
            let kind = kind(graph, expr, &likeness.kinds);
            likeness.kinds.push(kind);
            if let Node::Sum { terms, .. } = graph.node(expr) {
                for part in likeness.parts(terms) {
                    sums.entry(likeness.kind(&part)).or_default().add(&part);
                }
            }
        }
        let several = sums.into_iter().filter(|(_, sums)| sums.count > 1);
        likeness.forms = several.map(|(kind, sums)| (kind, sums.form())).collect();
        likeness
    }

    /// Terms that depend on the same parts and joints are added up first, because the same terms may be in other sums,
    /// too: those of a bushing are in the sums of both its bodies.
    pub(super) fn parts<'t>(&self, terms: &'t [(Expr, Number)]) -> Vec<Terms<'t>> {
        let owner = |term: Expr| self.owners.get(term.index()).copied().unwrap_or(EMPTY);
        let mut same = 1;
        while same < terms.len() && owner(terms[same].0) == owner(terms[0].0) {
            same += 1;
        }
        if same >= terms.len() {
            return vec![Cow::Borrowed(terms)];
        }
        let mut parts: Vec<(u32, Vec<(Expr, Number)>)> = Vec::new();
        for &(term, coefficient) in terms {
            let owner = owner(term);
            match parts.iter_mut().find(|(other, _)| *other == owner) {
                Some((_, part)) => part.push((term, coefficient)),
                None => parts.push((owner, vec![(term, coefficient)])),
            }
        }
        let parts = parts.into_iter();
        parts.map(|(_, part)| Cow::Owned(part)).collect()
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
        let mut all = 0;
        for &(term, coefficient) in terms {
            all = mixed(mixed(all, self.kinds[term.index()]), number(coefficient));
        }
        all
    }
}

/// Terms of a sum.
type Terms<'t> = Cow<'t, [(Expr, Number)]>;

/// The coefficients of the sums of a kind, one sum after the other.
#[derive(Default)]
struct Sums {
    count: usize,
    coefficients: Vec<f64>,
}

impl Sums {
    fn add(&mut self, terms: &[(Expr, Number)]) {
        self.count += 1;
        for (_, coefficient) in terms {
            self.coefficients.push(coefficient.value());
        }
    }

    /// Terms are of one group if their coefficients have the same magnitude in each sum, and the same relation of signs.
    fn form(&self) -> Vec<Slot> {
        let width = self.coefficients.len() / self.count;
        let first_sum = &self.coefficients[..width];
        let mut firsts: Map<u64, usize> = Map::default();
        let mut slots = Vec::with_capacity(width);
        for at in 0..width {
            let sign = first_sum[at] < 0.0;
            let (mut key, mut has_sign) = (0, true);
            let mut next = at;
            while next < self.coefficients.len() {
                let coefficient = self.coefficients[next];
                let is_same = (coefficient < 0.0) == sign;
                has_sign &= is_same;
                let magnitude = Number::new(coefficient.abs());
                key = mixed(mixed(key, magnitude.bits()), u64::from(is_same));
                next += width;
            }
            let first = *firsts.entry(key).or_insert(at);
            slots.push(Slot {
                first,
                opposite: (first_sum[first] < 0.0) != sign,
                has_sign,
            });
        }
        slots
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
        Node::Constant(value) => mixed(0, number(*value)),
        Node::Symbol(symbol) => {
            let entry = match symbol {
                Symbol::Rotation(_, entry) | Symbol::LocalRotation(_, entry) => *entry,
                _ => 0,
            };
            hash((1, std::mem::discriminant(symbol), entry))
        }
        Node::Sum { constant, terms } => {
            let mut all = mixed(2, number(*constant));
            for &(term, coefficient) in terms {
                all = mixed(mixed(all, of(term)), number(coefficient));
            }
            all
        }
        Node::Product(factors) => {
            let mut all = 3;
            for &(factor, power) in factors {
                all = mixed(mixed(all, of(factor)), power as u64);
            }
            all
        }
        Node::Function(function, x) => hash((4, *function as u64, of(*x))),
        Node::Atan2(y, x) => hash((5, of(*y), of(*x))),
        Node::Larger(a, b) => hash((13, of(*a), of(*b))),
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
fn number(number: Number) -> u64 {
    const ANY: u64 = f64::NAN.to_bits();
    match is_simple(number.value()) {
        true => number.bits(),
        false => ANY,
    }
}
