//! Programs as text, for snapshots and the book.

use super::{Function, Operand, Operation, Place, Program};
use crate::symbolic::Graph;
use std::fmt::Write;

impl Program {
    /// The whole program; `graph` names the symbols.
    pub fn text(&self, graph: &Graph) -> String {
        let mut out = String::new();
        for (slot, constant) in self.constants.iter().enumerate() {
            let _ = writeln!(out, "k{slot} = {}", constant.text);
        }
        for function in &self.functions {
            let _ = write!(out, "\n{}", function.text(graph));
        }
        out
    }
}

impl Function {
    /// The function as text, one operation a line.
    pub fn text(&self, graph: &Graph) -> String {
        let name = |operand: &Operand| match operand {
            Operand::Number(number) => number.value().to_string(),
            Operand::Symbol(symbol) => graph.name(*symbol),
            Operand::Constant(slot) => format!("k{slot}"),
            Operand::Value(slot) => format!("t{slot}"),
        };
        let mut out = format!("{}    [{}]\n", self.name, self.cost());
        for (slot, operation) in self.operations.iter().enumerate() {
            let text = match operation {
                Operation::Add(a, b) => format!("{} + {}", name(a), name(b)),
                Operation::Subtract(a, b) => format!("{} - {}", name(a), name(b)),
                Operation::Multiply(a, b) => format!("{} * {}", name(a), name(b)),
                Operation::Divide(a, b) => format!("{} / {}", name(a), name(b)),
                Operation::Negate(a) => format!("-{}", name(a)),
                Operation::Call(function, a) => format!("{}({})", function.name(), name(a)),
                Operation::PivotInverse(pivot, whole) => {
                    format!("pivot_inverse({}, {})", name(pivot), name(whole))
                }
                Operation::Atan2(y, x) => format!("atan2({}, {})", name(y), name(x)),
                Operation::Larger(a, b) => format!("larger({}, {})", name(a), name(b)),
                Operation::Power(a, exponent) => format!("{}^{}", name(a), exponent.value()),
                Operation::Law(law, arguments) => {
                    let arguments: Vec<_> = arguments.iter().map(name).collect();
                    format!("law{law}({})", arguments.join(", "))
                }
                Operation::Table(table, order, x) => {
                    format!("{}({})", table.function_name(*order), name(x))
                }
                Operation::Part(call, None) => format!("value of t{call}"),
                Operation::Part(call, Some(partial)) => format!("partial {partial} of t{call}"),
            };
            let hint = self.names[slot]
                .as_ref()
                .map_or(String::new(), |hint| format!("    // {hint}"));
            let _ = writeln!(out, "  t{slot} = {text}{hint}");
        }
        for output in &self.outputs {
            let place = match output.place {
                Place::Value => "result".to_owned(),
                Place::Element(i) => format!("{}[{i}]", output.sink),
                Place::Entry(i, j) => format!("{}[{i}][{j}]", output.sink),
                Place::Tensor(i, j, k) => format!("{}[{i}][{j}][{k}]", output.sink),
                Place::Constant(slot) => format!("k{slot}"),
            };
            let _ = writeln!(out, "  {place} = {}", name(&output.value));
        }
        out
    }
}
