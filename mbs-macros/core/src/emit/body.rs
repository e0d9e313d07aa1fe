//! The body of a function as text: bindings, temporaries, writes.
//!
//! A value used once is written where it is used; one used more often gets a name. Grouping is kept exactly as in the
//! program, so that the compiled function and the interpreter agree to the last bit (up to the elementary functions).

use super::names::{self, Names, table_field};
use crate::dag::{Function, Operand, Operation, Output};
use crate::symbolic::{Function as Elementary, Graph, INTEGRAL, Symbol};

/// Expressions nested deeper than this get a temporary, for the reader's sake.
const DEEPEST: usize = 5;

/// More arguments are written where they are used, without a name of their own.
const MOST_BINDINGS: usize = 600;

/// How an operand is written in an inner place.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Unary,
    Atom,
}

/// Writes bodies.
pub(super) struct Body<'a> {
    graph: &'a Graph,
    pub(super) function: &'a Function,
    names: Names,
    /// Whether an operation has a temporary of its own.
    named: Vec<bool>,
    /// How constants and parameters are addressed: `self.` or nothing.
    constants: &'a str,
    parameters: &'a str,
    /// The type that has the tables of numbers.
    tables: &'a str,
}

impl<'a> Body<'a> {
    /// The body of a method of the system.
    pub(super) fn of_method(graph: &'a Graph, function: &'a Function) -> Self {
        Self::new(graph, function, ["self.", "self.parameters.", "Self"])
    }

    /// The body of a part of a long function; `place` is where it finds a value.
    pub(super) fn of_part(
        graph: &'a Graph,
        function: &'a Function,
        place: impl Fn(usize) -> String,
    ) -> Self {
        let mut body = Self::of_method(graph, function);
        for (symbol, (_, source)) in &mut body.names.bound {
            if let Symbol::Place(index) = symbol {
                *source = place(*index as usize);
            }
        }
        body
    }

    /// The body of a function in which constants are variables and parameters come from `self`; `system` is the type of
    /// the equations.
    pub(super) fn of_preparation(
        graph: &'a Graph,
        function: &'a Function,
        system: &'a str,
    ) -> Self {
        Self::new(graph, function, ["", "self.", system])
    }

    fn new(
        graph: &'a Graph,
        function: &'a Function,
        [constants, parameters, tables]: [&'a str; 3],
    ) -> Self {
        let mut names = Names::new(graph, function);
        if names.bound.len() > MOST_BINDINGS {
            let bound = names.bound.values_mut();
            bound.for_each(|(name, source)| name.clone_from(source));
        }
        let mut body = Body {
            graph,
            function,
            names,
            named: Vec::new(),
            constants,
            parameters,
            tables,
        };
        body.choose_temporaries();
        body
    }

    fn choose_temporaries(&mut self) {
        let count = self.function.operations.len();
        let mut uses = vec![0usize; count];
        let mut note = |operand: Operand| {
            if let Operand::Value(slot) = operand {
                uses[slot] += 1;
            }
        };
        self.function
            .operations
            .iter()
            .for_each(|operation| operation.for_each_operand(&mut note));
        self.function
            .outputs
            .iter()
            .for_each(|output| note(output.value));
        let mut depth = vec![0usize; count];
        for (slot, operation) in self.function.operations.iter().enumerate() {
            let mut deepest = 0;
            operation.for_each_operand(|operand| {
                if let Operand::Value(inner) = operand {
                    deepest = deepest.max(depth[inner]);
                }
            });
            let is_law = matches!(operation, Operation::Law(..));
            let named = uses[slot] > 1
                || is_law
                || deepest >= DEEPEST
                || self.function.names[slot].is_some();
            depth[slot] = if named { 0 } else { deepest + 1 };
            self.named.push(named && uses[slot] > 0);
        }
    }

    /// Arguments that the body reads, each with its name.
    pub(super) fn bindings(&self) -> Vec<(&str, &str)> {
        let bound = self.names.bound.values();
        bound
            .filter(|(name, source)| name != source)
            .map(|(name, source)| (name.as_str(), source.as_str()))
            .collect()
    }

    /// Operations with temporaries of their own, each with its name and its value.
    pub(super) fn temporaries(&self) -> impl Iterator<Item = (usize, &str, String)> {
        let slots = (0..self.function.operations.len()).filter(|&slot| self.named[slot]);
        slots.map(|slot| {
            let name = self.names.temporaries[slot].as_str();
            (slot, name, self.operation(slot, Precedence::Sum))
        })
    }

    /// The values of all outputs, in order.
    pub(super) fn values(&self) -> Vec<String> {
        self.function
            .outputs
            .iter()
            .map(|output| self.value(output))
            .collect()
    }

    /// The value of an output.
    pub(super) fn value(&self, output: &Output) -> String {
        self.operand(output.value, Precedence::Sum)
    }

    fn operand(&self, operand: Operand, outer: Precedence) -> String {
        match operand {
            Operand::Number(value) => {
                let value = value.value();
                let text = number(value);
                if value < 0.0 && outer > Precedence::Sum {
                    format!("({text})")
                } else {
                    text
                }
            }
            Operand::Constant(slot) => format!("{}k{slot}", self.constants),
            Operand::Symbol(symbol) => self.symbol(symbol),
            Operand::Value(slot) if self.named[slot] => self.names.temporaries[slot].clone(),
            Operand::Value(slot) => self.operation(slot, outer),
        }
    }

    fn symbol(&self, symbol: Symbol) -> String {
        if let Some((name, _)) = self.names.bound.get(&symbol) {
            return name.clone();
        }
        symbol_text(self.graph, symbol, [self.constants, self.parameters])
    }

    fn operation(&self, slot: usize, outer: Precedence) -> String {
        let (text, own) = match &self.function.operations[slot] {
            Operation::Add(a, b) => (self.binary(*a, "+", *b, Precedence::Sum), Precedence::Sum),
            Operation::Subtract(a, b) => {
                (self.binary(*a, "-", *b, Precedence::Sum), Precedence::Sum)
            }
            Operation::Multiply(a, b) => (
                self.binary(*a, "*", *b, Precedence::Product),
                Precedence::Product,
            ),
            Operation::Divide(a, b) => (
                self.binary(*a, "/", *b, Precedence::Product),
                Precedence::Product,
            ),
            Operation::Negate(a) => (
                format!("-{}", self.operand(*a, Precedence::Unary)),
                Precedence::Unary,
            ),
            Operation::PivotInverse(pivot, whole) => {
                let whole = self.operand(*whole, Precedence::Sum);
                let pivot = self.operand(*pivot, Precedence::Sum);
                (
                    format!("::mbs_runtime::generated::pivot_inverse({pivot}, {whole})"),
                    Precedence::Atom,
                )
            }
            Operation::Call(function, a) => (self.call(*function, *a), Precedence::Atom),
            Operation::Atan2(y, x) => {
                let x = self.operand(*x, Precedence::Sum);
                (
                    format!("f64::atan2({}, {x})", self.operand(*y, Precedence::Sum)),
                    Precedence::Atom,
                )
            }
            Operation::Larger(a, b) => {
                let b = self.operand(*b, Precedence::Sum);
                let a = self.operand(*a, Precedence::Sum);
                (
                    format!("::mbs_runtime::generated::larger({a}, {b})"),
                    Precedence::Atom,
                )
            }
            Operation::Power(a, exponent) => (
                format!("{}.powf({})", self.receiver(*a), number(exponent.value())),
                Precedence::Atom,
            ),
            Operation::Law(law, arguments) => {
                let arguments: Vec<_> = arguments
                    .iter()
                    .map(|x| self.operand(*x, Precedence::Sum))
                    .collect();
                (
                    format!("Self::law_{law}([{}])", arguments.join(", ")),
                    Precedence::Atom,
                )
            }
            Operation::Table(table, order, x) => {
                let method = match *order {
                    INTEGRAL => "integral",
                    0 => "value",
                    1 => "slope",
                    2 => "second",
                    _ => "third",
                };
                let x = self.operand(*x, Precedence::Sum);
                let repeated = if table.is_periodic { ".periodic()" } else { "" };
                let table = match table.data {
                    None => format!("{}::TABLE_{}", self.tables, table.index),
                    Some(_) => format!("{}{}.as_table()", self.constants, table_field(table)),
                };
                (format!("{table}{repeated}.{method}({x})"), Precedence::Atom)
            }
            Operation::Part(law, None) => (
                format!("{}.0", self.names.temporaries[*law]),
                Precedence::Atom,
            ),
            Operation::Part(law, Some(partial)) => (
                format!("{}.1[{partial}]", self.names.temporaries[*law]),
                Precedence::Atom,
            ),
        };
        // A unary minus in front of a method call would apply to its result: parenthesise all but atoms there.
        if own < outer {
            format!("({text})")
        } else {
            text
        }
    }

    /// Left operands associate by themselves; right ones of the same precedence are parenthesised, to keep the grouping.
    fn binary(&self, a: Operand, operator: &str, b: Operand, own: Precedence) -> String {
        let above = if own == Precedence::Sum {
            Precedence::Product
        } else {
            Precedence::Unary
        };
        // a + (b + c) is b + c + a, to the last bit.
        let commutes = matches!(operator, "+" | "*");
        let (a, b) = if commutes && self.continues(b, own) && !self.continues(a, own) {
            (b, a)
        } else {
            (a, b)
        };
        format!(
            "{} {operator} {}",
            self.operand(a, own),
            self.operand(b, above)
        )
    }

    /// Whether an operand is written out as a sum (or product) that needs no parentheses on the left of another.
    fn continues(&self, operand: Operand, own: Precedence) -> bool {
        let Operand::Value(slot) = operand else {
            return false;
        };
        let same = match self.function.operations[slot] {
            Operation::Add(..) | Operation::Subtract(..) => Precedence::Sum,
            Operation::Multiply(..) | Operation::Divide(..) => Precedence::Product,
            _ => return false,
        };
        same == own && !self.named[slot]
    }

    fn call(&self, function: Elementary, argument: Operand) -> String {
        let plain = self.operand(argument, Precedence::Sum);
        match function {
            Elementary::Sign => format!("::mbs_runtime::generated::sign({plain})"),
            Elementary::Step => format!("::mbs_runtime::generated::step({plain})"),
            Elementary::Nonzero => format!("::mbs_runtime::generated::nonzero({plain})"),
            _ => format!("{}.{}()", self.receiver(argument), function.name()),
        }
    }

    /// What a method is called on: `2.0.sin()` needs its type.
    fn receiver(&self, operand: Operand) -> String {
        match operand {
            Operand::Number(value) if value.value().is_finite() => {
                format!("({}_f64)", number(value.value()))
            }
            _ => self.operand(operand, Precedence::Atom),
        }
    }
}

/// An argument or constant of a method, where it stands.
pub(super) fn source(graph: &Graph, operand: Operand) -> String {
    match operand {
        Operand::Number(value) => number(value.value()),
        Operand::Constant(slot) => format!("self.k{slot}"),
        Operand::Symbol(symbol) => names::source(symbol)
            .unwrap_or_else(|| symbol_text(graph, symbol, ["self.", "self.parameters."])),
        // The inputs of parts are not computed.
        Operand::Value(slot) => format!("values[{slot}]"),
    }
}

/// A parameter or a constant; `constants` and `parameters` are how these are addressed.
pub(super) fn symbol_text(
    graph: &Graph,
    symbol: Symbol,
    [constants, parameters]: [&str; 2],
) -> String {
    match symbol {
        Symbol::Parameter(_) => format!("{parameters}{}", graph.name(symbol)),
        Symbol::InverseMass(i, j) => format!("{constants}inverse_mass[({i}, {j})]"),
        other => graph.name(other),
    }
}

/// A number that reads back as itself.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else if value.is_nan() {
        "f64::NAN".to_owned()
    } else if value > 0.0 {
        "f64::INFINITY".to_owned()
    } else {
        "f64::NEG_INFINITY".to_owned()
    }
}
