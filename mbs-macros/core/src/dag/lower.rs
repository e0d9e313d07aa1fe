//! Expressions → operations.
//!
//! Products are split into a hoisted constant part and a varying one, and every operation is made once per function.

use super::likeness::Likeness;
use super::reciprocals::share_reciprocals;
use super::{Function, Operand, Operation, Output, Place};
use crate::model::Layout;
use crate::symbolic::{Expr, Graph, Map, Node, Symbol};

/// Factors of a product with their powers.
type Factors = Vec<(Expr, i32)>;

/// Constants found so far, shared by all functions of a mechanism.
#[derive(Debug, Default)]
pub(super) struct Hoisted {
    /// Where coordinates are stored.
    layout: Layout,
    pub list: Vec<Expr>,
    index: Map<Expr, usize>,
    /// Whether each expression depends on parameters only, where that was asked.
    known: Vec<Option<bool>>,
}

impl Hoisted {
    pub(super) fn new(layout: Layout) -> Self {
        Hoisted {
            layout,
            ..Hoisted::default()
        }
    }

    /// Whether an expression depends on parameters only.
    pub(super) fn is_known(&mut self, graph: &Graph, expr: Expr) -> bool {
        if let Some(&Some(known)) = self.known.get(expr.index()) {
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
        if expr.index() >= self.known.len() {
            self.known.resize(graph.len(), None);
        }
        self.known[expr.index()] = Some(known);
        known
    }

    /// Factors that depend on parameters only, if these are set apart, and the others.
    fn parted(&mut self, graph: &Graph, factors: &[(Expr, i32)], apart: bool) -> [Factors; 2] {
        let (mut known, mut varying) = (Factors::new(), Factors::with_capacity(factors.len()));
        for &(factor, power) in factors {
            match apart && self.is_known(graph, factor) {
                true => known.push((factor, power)),
                false => varying.push((factor, power)),
            }
        }
        [known, varying]
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.list.len()
    }

    /// Keeps the first ones: the others belong to a function that is not used.
    pub(super) fn keep(&mut self, count: usize) {
        self.list.truncate(count);
        self.index = self.list.iter().copied().zip(0..).collect();
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
    pub(super) graph: &'a mut Graph,
    pub(super) hoisted: &'a mut Hoisted,
    /// If sums that are alike shall get the same operations.
    pub(super) likeness: Option<&'a Likeness>,
    /// Off while the constants themselves are computed.
    pub(super) hoist: bool,
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
            likeness: None,
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

    /// A lowering in which sums that are alike get the same operations.
    pub(super) fn with_likeness(mut self, likeness: Option<&'a Likeness>) -> Self {
        self.likeness = likeness;
        self
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
            Node::Function(crate::symbolic::Function::Apart, x) => self.operand(x),
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
            Node::Larger(a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                self.push(Operation::Larger(a, b))
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
            Node::Table { table, order, x } => {
                let x = self.operand(x);
                self.push(Operation::Table(table, order, x))
            }
        };
        if let (Operand::Value(value), Some(name)) = (operand, self.graph.suggested_name(expr)) {
            self.names[value].get_or_insert_with(|| name.to_owned());
        }
        self.done.insert(expr, operand);
        operand
    }

    /// A term as (known factor, varying factor).
    pub(super) fn split(&mut self, term: Expr) -> (Option<Expr>, Expr) {
        let Node::Product(factors) = self.graph.node(term) else {
            return (None, term);
        };
        let [known, varying] = self.hoisted.parted(self.graph, factors, self.hoist);
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
        let [known, varying] = self.hoisted.parted(self.graph, factors, self.hoist);
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

    /// −a.
    pub(super) fn negative(&mut self, a: Operand) -> Operand {
        match a {
            Operand::Number(number) => Operand::number(-number.value()),
            Operand::Value(slot) => match self.operations[slot] {
                Operation::Negate(inner) => inner,
                Operation::Subtract(x, y) => self.push(Operation::Subtract(y, x)),
                _ => self.push(Operation::Negate(a)),
            },
            _ => self.push(Operation::Negate(a)),
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
