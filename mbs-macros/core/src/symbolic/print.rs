//! Expressions as text, for people: stable, infix, with as few parentheses as precedence allows.

use super::{Expr, Function, Graph, Node, Number};
use std::collections::BTreeMap;

impl Function {
    /// The name used in declarations, dumps and (as a method of `f64`) in generated code.
    pub fn name(self) -> &'static str {
        match self {
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Tan => "tan",
            Function::Asin => "asin",
            Function::Acos => "acos",
            Function::Atan => "atan",
            Function::Sqrt => "sqrt",
            Function::Exp => "exp",
            Function::Ln => "ln",
            Function::Sinh => "sinh",
            Function::Cosh => "cosh",
            Function::Tanh => "tanh",
            Function::Abs => "abs",
            Function::Sign => "sign",
            Function::Step => "step",
            Function::Round => "round",
            Function::Nonzero => "nonzero",
            Function::Same | Function::Apart => "",
        }
    }
}

/// How tightly the context binds: a sum inside a product needs parentheses.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Power,
}

impl Graph {
    /// The expression as text.
    pub fn text(&self, expr: Expr) -> String {
        self.text_naming(expr, &BTreeMap::new())
    }

    /// The beginning of this text, up to about `most` bytes: written out, an expression whose operands have common parts may be
    /// exponentially long.
    pub fn start_of_text(&self, expr: Expr, most: usize) -> String {
        let mut out = String::new();
        let names = &BTreeMap::new();
        let writer = Writer {
            graph: self,
            names,
            most,
        };
        writer.write_node(expr, Precedence::Sum, &mut out);
        if out.len() > most {
            out.push_str(" …");
        }
        out
    }

    /// The expression as text, with names in place of those of its operands that have one.
    pub fn text_naming(&self, expr: Expr, names: &BTreeMap<Expr, String>) -> String {
        let mut out = String::new();
        let writer = Writer {
            graph: self,
            names,
            most: usize::MAX,
        };
        writer.write_node(expr, Precedence::Sum, &mut out);
        out
    }
}

struct Writer<'a> {
    graph: &'a Graph,
    names: &'a BTreeMap<Expr, String>,
    /// With so many bytes nothing is added.
    most: usize,
}

impl Writer<'_> {
    fn write(&self, expr: Expr, outer: Precedence, out: &mut String) {
        match self.names.get(&expr) {
            Some(name) => out.push_str(name),
            None => self.write_node(expr, outer, out),
        }
    }

    fn write_node(&self, expr: Expr, outer: Precedence, out: &mut String) {
        if out.len() > self.most {
            return;
        }
        match self.graph.node(expr) {
            Node::Constant(number) => {
                let value = number.value();
                if value < 0.0 && outer > Precedence::Sum {
                    out.push_str(&format!("({value})"));
                } else {
                    out.push_str(&value.to_string());
                }
            }
            Node::Symbol(symbol) => out.push_str(&self.graph.name(*symbol)),
            Node::Sum { constant, terms } => {
                let single = *constant == Number::ZERO && terms.len() == 1;
                let parentheses = outer
                    > if single {
                        Precedence::Product
                    } else {
                        Precedence::Sum
                    };
                let negative_single = single && terms[0].1.value() < 0.0 && outer > Precedence::Sum;
                self.parenthesise(parentheses || negative_single, out, |out| {
                    self.write_sum(*constant, terms, out)
                });
            }
            Node::Product(factors) => {
                self.parenthesise(outer > Precedence::Product, out, |out| {
                    self.write_product(factors, out)
                });
            }
            Node::Function(function, x) => {
                out.push_str(function.name());
                self.parenthesise(true, out, |out| self.write(*x, Precedence::Sum, out));
            }
            Node::Power(x, exponent) => {
                self.write(*x, Precedence::Power, out);
                out.push_str(&format!("^{}", exponent.value()));
            }
            Node::Atan2(y, x) => self.write_of_two("atan2", [*y, *x], out),
            Node::Larger(a, b) => self.write_of_two("max", [*a, *b], out),
            Node::Law {
                law,
                partial,
                arguments,
            } => {
                out.push_str(&match partial {
                    None => format!("law{law}("),
                    Some(slot) => format!("law{law}_d{slot}("),
                });
                for (slot, &x) in arguments.iter().enumerate() {
                    if slot > 0 {
                        out.push_str(", ");
                    }
                    self.write(x, Precedence::Sum, out);
                }
                out.push(')');
            }
            Node::Table { table, order, x } => {
                out.push_str(&table.function_name(*order));
                self.parenthesise(true, out, |out| self.write(*x, Precedence::Sum, out));
            }
        }
    }

    fn parenthesise(&self, needed: bool, out: &mut String, inside: impl FnOnce(&mut String)) {
        if needed {
            out.push('(');
        }
        inside(out);
        if needed {
            out.push(')');
        }
    }

    fn write_sum(&self, constant: Number, terms: &[(Expr, Number)], out: &mut String) {
        let mut first = true;
        for &(term, coefficient) in terms {
            let coefficient = coefficient.value();
            match (first, coefficient < 0.0) {
                (true, true) => out.push('-'),
                (true, false) => {}
                (false, true) => out.push_str(" - "),
                (false, false) => out.push_str(" + "),
            }
            first = false;
            if coefficient.abs() != 1.0 {
                out.push_str(&format!("{}·", coefficient.abs()));
            }
            self.write(term, Precedence::Product, out);
        }
        let constant = constant.value();
        if constant != 0.0 {
            out.push_str(&format!(
                " {} {}",
                if constant < 0.0 { "-" } else { "+" },
                constant.abs()
            ));
        }
    }

    /// A function of two values.
    fn write_of_two(&self, name: &str, [a, b]: [Expr; 2], out: &mut String) {
        out.push_str(name);
        out.push('(');
        self.write(a, Precedence::Sum, out);
        out.push_str(", ");
        self.write(b, Precedence::Sum, out);
        out.push(')');
    }

    fn write_product(&self, factors: &[(Expr, i32)], out: &mut String) {
        let mut first = true;
        for &(factor, power) in factors.iter().filter(|(_, power)| *power > 0) {
            if !first {
                out.push('·');
            }
            first = false;
            self.write_factor(factor, power, out);
        }
        if first {
            out.push('1');
        }
        for &(factor, power) in factors.iter().filter(|(_, power)| *power < 0) {
            out.push('/');
            self.write_factor(factor, -power, out);
        }
    }

    fn write_factor(&self, factor: Expr, power: i32, out: &mut String) {
        self.write(factor, Precedence::Power, out);
        if power != 1 {
            out.push_str(&format!("^{power}"));
        }
    }
}
