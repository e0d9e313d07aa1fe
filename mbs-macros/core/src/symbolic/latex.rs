//! Expressions as LaTeX, for `mbs explain --latex` and the book.

use super::{Expr, Function, Graph, INTEGRAL, Node, Number};

impl Graph {
    /// The expression as LaTeX.
    pub fn latex(&self, expr: Expr) -> String {
        match self.node(expr) {
            Node::Constant(constant) => number(constant.value()),
            Node::Symbol(symbol) => latex_identifier(&self.name(*symbol)),
            Node::Sum { constant, terms } => self.latex_sum(constant.value(), terms),
            Node::Product(factors) => self.latex_product(factors),
            Node::Function(Function::Apart | Function::Nonzero, x) => self.latex(*x),
            Node::Function(Function::Sqrt, x) => format!("\\sqrt{{{}}}", self.latex(*x)),
            Node::Function(Function::Abs, x) => format!("\\left|{}\\right|", self.latex(*x)),
            Node::Function(function, x) => {
                format!("\\{}{}", latex_function(*function), self.latex_group(*x))
            }
            Node::Power(x, exponent) => {
                format!("{}^{{{}}}", self.latex_group(*x), exponent.value())
            }
            Node::Atan2(y, x) => {
                format!(
                    "\\operatorname{{atan2}}\\left({}, {}\\right)",
                    self.latex(*y),
                    self.latex(*x)
                )
            }
            Node::Larger(a, b) => {
                format!("\\max\\left({}, {}\\right)", self.latex(*a), self.latex(*b))
            }
            Node::Law {
                law,
                partial,
                arguments,
            } => {
                let arguments: Vec<_> = arguments.iter().map(|&x| self.latex(x)).collect();
                let partial = partial.map_or(String::new(), |slot| format!("_{{,{slot}}}"));
                format!(
                    "\\ell_{{{law}}}{partial}\\left({}\\right)",
                    arguments.join(", ")
                )
            }
            Node::Table { table, order, x } => {
                let name = latex_identifier(&table.name);
                let name = match *order {
                    INTEGRAL => format!("\\int {name}"),
                    order => name + &"'".repeat(order as usize),
                };
                format!("{name}\\left({}\\right)", self.latex(*x))
            }
        }
    }

    fn latex_sum(&self, constant: f64, terms: &[(Expr, Number)]) -> String {
        let mut out = String::new();
        for &(term, coefficient) in terms {
            let coefficient = coefficient.value();
            let sign = match (out.is_empty(), coefficient < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, true) => " - ",
                (false, false) => " + ",
            };
            out.push_str(sign);
            if coefficient.abs() != 1.0 {
                out.push_str(&number(coefficient.abs()));
                out.push_str("\\,");
            }
            let is_sum = matches!(self.node(term), Node::Sum { .. });
            out.push_str(&if is_sum {
                self.latex_group(term)
            } else {
                self.latex(term)
            });
        }
        if constant != 0.0 {
            out.push_str(if constant < 0.0 { " - " } else { " + " });
            out.push_str(&number(constant.abs()));
        }
        out
    }

    fn latex_product(&self, factors: &[(Expr, i32)]) -> String {
        let side = |positive: bool| -> String {
            let chosen: Vec<_> = factors
                .iter()
                .filter(|(_, power)| (*power > 0) == positive)
                .map(|&(factor, power)| {
                    let base = match self.node(factor) {
                        Node::Symbol(_) => self.latex(factor),
                        Node::Function(..) if power.abs() == 1 => self.latex(factor),
                        _ => self.latex_group(factor),
                    };
                    if power.abs() == 1 {
                        base
                    } else {
                        format!("{{{base}}}^{{{}}}", power.abs())
                    }
                })
                .collect();
            chosen.join("\\,")
        };
        let (numerator, denominator) = (side(true), side(false));
        match (numerator.is_empty(), denominator.is_empty()) {
            (_, true) => numerator,
            (true, false) => format!("\\frac{{1}}{{{denominator}}}"),
            (false, false) => format!("\\frac{{{numerator}}}{{{denominator}}}"),
        }
    }

    fn latex_group(&self, expr: Expr) -> String {
        format!("\\left({}\\right)", self.latex(expr))
    }
}

fn latex_function(function: Function) -> &'static str {
    match function {
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        Function::Atan => "arctan",
        Function::Sign => "operatorname{sgn}",
        Function::Step => "Theta",
        Function::Round => "operatorname{round}",
        other => other.name(),
    }
}

fn number(value: f64) -> String {
    let text = format!("{value}");
    let size = value.abs();
    match text.len() > 9 {
        true if size != 0.0 && !(1e-3..1e9).contains(&size) => {
            let text = format!("{value:.5e}");
            match text.split_once('e') {
                Some((digits, power)) => format!("{digits}\\cdot 10^{{{power}}}"),
                None => text,
            }
        }
        true => format!("{value:.6}"),
        false => text,
    }
}

/// A name as LaTeX: `crank.b.x'` becomes crank with the index b,x and a dot, `crank[3].b.x` has the index 3,b,x.
pub fn latex_identifier(name: &str) -> String {
    let accent = match name.len() - name.trim_end_matches('\'').len() {
        0 => "",
        1 => "\\dot",
        _ => "\\ddot",
    };
    let escaped = name.trim_end_matches('\'').replace('_', "\\_");
    let escaped = escaped.replace('[', ".").replace(']', "");
    let (part, rest) = match escaped.split_once('.') {
        Some((part, rest)) => (
            part.to_owned(),
            format!("_{{\\mathrm{{{}}}}}", rest.replace('.', ",")),
        ),
        None => (escaped, String::new()),
    };
    let part = if part.chars().count() == 1 {
        part
    } else {
        format!("\\mathrm{{{part}}}")
    };
    if accent.is_empty() {
        format!("{part}{rest}")
    } else {
        format!("{accent}{{{part}}}{rest}")
    }
}
