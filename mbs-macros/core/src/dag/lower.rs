//! Expressions → operations.
//!
//! Sums are grouped by their constant factor (k x + k y = k (x + y), with k hoisted), products are split into a hoisted
//! constant part and a varying one, and every operation is made once per function.

use super::reciprocals::share_reciprocals;
use super::{Function, Operand, Operation, Output, Place};
use crate::model::Layout;
use crate::symbolic::{Expr, Graph, Map, Node, Number, Symbol};

/// Constants found so far, shared by all functions of a mechanism.
#[derive(Debug, Default)]
pub(super) struct Hoisted {
    /// Where coordinates are stored.
    layout: Layout,
    pub list: Vec<Expr>,
    index: Map<Expr, usize>,
    known: Map<Expr, bool>,
}

impl Hoisted {
    pub(super) fn new(layout: Layout) -> Self {
        Hoisted {
            layout,
            ..Hoisted::default()
        }
    }

    /// Whether an expression depends on parameters only.
    fn is_known(&mut self, graph: &Graph, expr: Expr) -> bool {
        if let Some(&known) = self.known.get(&expr) {
            return known;
        }
        let known = match graph.node(expr) {
            Node::Symbol(symbol) => symbol.is_parameter_like(),
            // A law may have a state (a table, a counter), so that it is not hoisted.
            Node::Law { .. } => false,
            _ => {
                let mut all = true;
                graph.for_each_operand(expr, |operand| all = all && self.is_known(graph, operand));
                all
            }
        };
        self.known.insert(expr, known);
        known
    }

    fn slot(&mut self, expr: Expr) -> usize {
        *self.index.entry(expr).or_insert_with(|| {
            self.list.push(expr);
            self.list.len() - 1
        })
    }
}

/// Lowers the outputs of one function.
pub(super) struct Lowering<'a> {
    graph: &'a mut Graph,
    hoisted: &'a mut Hoisted,
    /// Off while the constants themselves are computed.
    hoist: bool,
    operations: Vec<Operation>,
    names: Vec<Option<String>>,
    done: Map<Expr, Operand>,
    made: Map<Operation, Operand>,
    outputs: Vec<Output>,
}

impl<'a> Lowering<'a> {
    pub(super) fn new(graph: &'a mut Graph, hoisted: &'a mut Hoisted) -> Self {
        Lowering {
            graph,
            hoisted,
            hoist: true,
            operations: Vec::new(),
            names: Vec::new(),
            done: Map::default(),
            made: Map::default(),
            outputs: Vec::new(),
        }
    }

    /// A lowering that computes constants instead of referring to them; `known` are those computed earlier.
    pub(super) fn of_constants(
        graph: &'a mut Graph,
        hoisted: &'a mut Hoisted,
        known: &[(Expr, usize)],
    ) -> Self {
        let mut lowering = Lowering::new(graph, hoisted);
        lowering.hoist = false;
        lowering.done = known
            .iter()
            .map(|&(expr, slot)| (expr, Operand::Constant(slot)))
            .collect();
        lowering
    }

    /// The graph to build expressions in.
    pub(super) fn graph(&mut self) -> &mut Graph {
        self.graph
    }

    /// Adds an output.
    pub(super) fn output(&mut self, sink: &'static str, place: Place, expr: Expr) {
        let value = self.operand(expr);
        self.write(sink, place, value);
    }

    /// Writes a value that was computed here.
    pub(super) fn write(&mut self, sink: &'static str, place: Place, value: Operand) {
        self.outputs.push(Output { sink, place, value });
    }

    /// From now on `expr` stands for a value that was computed here.
    pub(super) fn bind(&mut self, expr: Expr, value: Operand) {
        self.done.insert(expr, value);
    }

    /// Suggests a name for a value that was computed here.
    pub(super) fn name(&mut self, value: Operand, name: impl FnOnce() -> String) {
        if let Operand::Value(slot) = value {
            self.names[slot].get_or_insert_with(name);
        }
    }

    /// The function.
    pub(super) fn finish(self, name: &'static str) -> Function {
        let function = Function {
            name,
            operations: self.operations,
            names: self.names,
            outputs: self.outputs,
        };
        if self.hoist {
            share_reciprocals(function)
        } else {
            function
        }
    }

    /// The value of an expression.
    pub(super) fn operand(&mut self, expr: Expr) -> Operand {
        if let Some(&known) = self.done.get(&expr) {
            return known;
        }
        let operand = match self.graph.node(expr).clone() {
            Node::Constant(number) => Operand::Number(number),
            Node::Symbol(Symbol::Rotation(first, entry)) => {
                let slot = self.hoisted.layout.slots[first as usize] as u32;
                let quaternion = [0, 1, 2, 3].map(|k| self.graph.symbol(Symbol::Stored(slot + k)));
                let expr = self.graph.rotation_entry(quaternion, entry);
                let name = self.graph.name(Symbol::Rotation(first, entry));
                self.graph.suggest_name(expr, name.replace('.', "_"));
                self.operand(expr)
            }
            Node::Symbol(symbol) => match self.hoisted.layout.slot(symbol) {
                Some(slot) => Operand::Symbol(Symbol::Stored(slot as u32)),
                None => Operand::Symbol(symbol),
            },
            _ if self.hoist && self.hoisted.is_known(self.graph, expr) => {
                Operand::Constant(self.hoisted.slot(expr))
            }
            Node::Sum { constant, terms } => self.sum(constant.value(), &terms),
            Node::Product(factors) => self.product(&factors),
            Node::Function(function, x) => {
                let x = self.operand(x);
                self.push(Operation::Call(function, x))
            }
            Node::Power(x, exponent) => {
                let x = self.operand(x);
                self.push(Operation::Power(x, exponent))
            }
            Node::Atan2(y, x) => {
                let (y, x) = (self.operand(y), self.operand(x));
                self.push(Operation::Atan2(y, x))
            }
            Node::Law {
                law,
                partial,
                arguments,
            } => {
                let arguments = arguments.iter().map(|&x| self.operand(x)).collect();
                match self.push(Operation::Law(law, arguments)) {
                    Operand::Value(call) => self.push(Operation::Part(call, partial)),
                    other => other,
                }
            }
        };
        if let (Operand::Value(value), Some(name)) = (operand, self.graph.suggested_name(expr)) {
            self.names[value].get_or_insert_with(|| name.to_owned());
        }
        self.done.insert(expr, operand);
        operand
    }

    /// constant + Σ coefficient · term.
    fn sum(&mut self, constant: f64, terms: &[(Expr, Number)]) -> Operand {
        let Grouped { known, groups } = self.group(terms);
        // Signed summands: (value, negative).
        let mut summands: Vec<(Operand, bool)> = Vec::new();
        for Group {
            magnitude,
            factor,
            parts,
        } in groups
        {
            if magnitude == 1.0 && factor.is_none() {
                for (varying, negative) in parts {
                    summands.push((self.operand(varying), negative));
                }
                continue;
            }
            let constant = self.graph.constant(magnitude);
            let factor = match factor {
                Some(factor) => self.graph.mul(constant, factor),
                None => constant,
            };
            let factor = self.operand(factor);
            // The sign of a single term is moved outside, so that it can become a subtraction.
            let negative = parts.iter().all(|(_, negative)| *negative);
            let inner: Vec<_> = parts
                .iter()
                .map(|&(varying, sign)| (self.operand(varying), sign != negative))
                .collect();
            let sum = self.signed_sum(&inner);
            summands.push((self.push(Operation::Multiply(factor, sum)), negative));
        }
        if !known.is_empty() || constant != 0.0 {
            let known = self.graph.linear(constant, &known);
            match self.graph.as_constant(known) {
                Some(value) if value < 0.0 => summands.push((Operand::number(-value), true)),
                _ => {
                    let operand = self.operand(known);
                    summands.push((operand, false));
                }
            }
        }
        self.signed_sum(&summands)
    }

    /// Terms as known part and groups. Known factors of the same varying part add up first, k x + l x = (k + l) x; then
    /// varying parts with the same factor form a group, k x + k y = k (x + y).
    fn group(&mut self, terms: &[(Expr, Number)]) -> Grouped {
        let mut known: Vec<(Expr, f64)> = Vec::new();
        let mut by_varying: Vec<(Expr, Vec<(Option<Expr>, f64)>)> = Vec::new();
        for &(term, coefficient) in terms {
            let coefficient = coefficient.value();
            if self.hoist && self.hoisted.is_known(self.graph, term) {
                known.push((term, coefficient));
                continue;
            }
            let (factor, varying) = self.split(term);
            match by_varying.iter_mut().find(|(other, _)| *other == varying) {
                Some((_, factors)) => factors.push((factor, coefficient)),
                None => by_varying.push((varying, vec![(factor, coefficient)])),
            }
        }
        let mut groups: Vec<Group> = Vec::new();
        for (varying, factors) in by_varying {
            let (factor, coefficient) = match factors.as_slice() {
                [single] => *single,
                several => {
                    let one = self.graph.one();
                    let terms: Vec<_> = several
                        .iter()
                        .map(|&(factor, c)| (factor.unwrap_or(one), c))
                        .collect();
                    (Some(self.graph.linear(0.0, &terms)), 1.0)
                }
            };
            let magnitude = coefficient.abs();
            let part = (varying, coefficient < 0.0);
            match groups
                .iter_mut()
                .find(|group| group.magnitude == magnitude && group.factor == factor)
            {
                Some(group) => group.parts.push(part),
                None => groups.push(Group {
                    magnitude,
                    factor,
                    parts: vec![part],
                }),
            }
        }
        Grouped { known, groups }
    }

    fn signed_sum(&mut self, summands: &[(Operand, bool)]) -> Operand {
        let positive = summands
            .iter()
            .filter(|(_, negative)| !negative)
            .map(|(operand, _)| *operand);
        let negative = summands
            .iter()
            .filter(|(_, negative)| *negative)
            .map(|(operand, _)| *operand);
        let mut total: Option<Operand> = None;
        for operand in positive {
            total = Some(match total {
                Some(before) => self.push(Operation::Add(before, operand)),
                None => operand,
            });
        }
        for operand in negative {
            total = Some(match total {
                Some(before) => self.push(Operation::Subtract(before, operand)),
                None => self.push(Operation::Negate(operand)),
            });
        }
        total.unwrap_or(Operand::number(0.0))
    }

    /// A term as (known factor, varying factor).
    fn split(&mut self, term: Expr) -> (Option<Expr>, Expr) {
        let Node::Product(factors) = self.graph.node(term).clone() else {
            return (None, term);
        };
        if !self.hoist {
            return (None, term);
        }
        let (known, varying): (Vec<_>, Vec<_>) = factors
            .iter()
            .partition(|(factor, _)| self.hoisted.is_known(self.graph, *factor));
        if known.is_empty() || varying.is_empty() {
            return (None, term);
        }
        (
            Some(self.graph.product(&known)),
            self.graph.product(&varying),
        )
    }

    /// Π factor^power.
    fn product(&mut self, factors: &[(Expr, i32)]) -> Operand {
        let (known, varying): (Vec<(Expr, i32)>, Vec<(Expr, i32)>) = factors
            .iter()
            .partition(|(factor, _)| self.hoist && self.hoisted.is_known(self.graph, *factor));
        let mut numerator: Option<Operand> = None;
        let mut denominator: Option<Operand> = None;
        for (factor, power) in varying {
            let base = self.operand(factor);
            let value = self.integer_power(base, power.unsigned_abs());
            let side = if power > 0 {
                &mut numerator
            } else {
                &mut denominator
            };
            *side = Some(match *side {
                Some(before) => self.push(Operation::Multiply(before, value)),
                None => value,
            });
        }
        if !known.is_empty() {
            let known = self.graph.product(&known);
            let known = self.operand(known);
            numerator = Some(match numerator {
                Some(value) => self.push(Operation::Multiply(known, value)),
                None => known,
            });
        }
        match (numerator, denominator) {
            (Some(value), None) => value,
            (value, Some(denominator)) => {
                let value = value.unwrap_or(Operand::number(1.0));
                self.push(Operation::Divide(value, denominator))
            }
            (None, None) => Operand::number(1.0),
        }
    }

    fn integer_power(&mut self, base: Operand, power: u32) -> Operand {
        if power == 1 {
            return base;
        }
        let half = self.integer_power(base, power / 2);
        let square = self.push(Operation::Multiply(half, half));
        if power.is_multiple_of(2) {
            square
        } else {
            self.push(Operation::Multiply(square, base))
        }
    }

    /// Makes an operation, unless the function has it already.
    pub(super) fn push(&mut self, operation: Operation) -> Operand {
        let operation = match operation {
            // One order for commuting operands, so that a b and b a are one.
            Operation::Add(a, b) if rank(b) < rank(a) => Operation::Add(b, a),
            Operation::Multiply(a, b) if rank(b) < rank(a) => Operation::Multiply(b, a),
            other => other,
        };
        if let Some(&known) = self.made.get(&operation) {
            return known;
        }
        self.operations.push(operation.clone());
        self.names.push(None);
        let operand = Operand::Value(self.operations.len() - 1);
        self.made.insert(operation, operand);
        operand
    }
}

/// An order of operands: numbers, constants, symbols, values.
fn rank(operand: Operand) -> (u8, u64, Option<Symbol>) {
    match operand {
        Operand::Number(value) => (0, value.value().to_bits(), None),
        Operand::Constant(slot) => (1, slot as u64, None),
        Operand::Symbol(symbol) => (2, 0, Some(symbol)),
        Operand::Value(value) => (3, value as u64, None),
    }
}

/// The terms of a sum, sorted for lowering.
struct Grouped {
    /// Terms that depend on parameters only, with their coefficients.
    known: Vec<(Expr, f64)>,
    groups: Vec<Group>,
}

/// magnitude · factor · Σ ± part.
struct Group {
    magnitude: f64,
    factor: Option<Expr>,
    /// Varying parts, and whether they count negative.
    parts: Vec<(Expr, bool)>,
}
