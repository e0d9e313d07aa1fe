//! The interpreter of programs; tests compare it with the symbolic interpreter and with the compiled code.

use super::{Function, Operand, Operation, Output};
use crate::symbolic::{LawEvaluation, Symbol, larger};

/// A pivot below this part of what it began with is round-off; the same number as in `mbs_runtime::generated`.
const ROUND_OFF: f64 = 1e-12;

/// Runs functions for given symbols and constants.
pub struct Run<'a> {
    /// The value of each symbol.
    pub symbols: &'a dyn Fn(Symbol) -> f64,
    /// The constants computed so far.
    pub constants: &'a [f64],
    /// The user's laws.
    pub laws: LawEvaluation<'a>,
}

impl Run<'_> {
    /// The outputs of a function with their values.
    pub fn function(&self, function: &Function) -> Vec<(Output, f64)> {
        let mut values: Vec<f64> = Vec::with_capacity(function.operations.len());
        let mut results: Vec<Option<(f64, Vec<f64>)>> = vec![None; function.operations.len()];
        for (slot, operation) in function.operations.iter().enumerate() {
            let get = |operand: &Operand| self.operand(*operand, &values);
            let value = match operation {
                Operation::Add(a, b) => get(a) + get(b),
                Operation::Subtract(a, b) => get(a) - get(b),
                Operation::Multiply(a, b) => get(a) * get(b),
                Operation::Divide(a, b) => get(a) / get(b),
                Operation::Negate(a) => -get(a),
                Operation::PivotInverse(pivot, whole) => {
                    let pivot = get(pivot);
                    if pivot > ROUND_OFF * get(whole) {
                        1.0 / pivot
                    } else {
                        0.0
                    }
                }
                Operation::Call(function, a) => function.evaluate(get(a)),
                Operation::Atan2(y, x) => get(y).atan2(get(x)),
                Operation::Larger(a, b) => larger(get(a), get(b)),
                Operation::Power(a, exponent) => get(a).powf(exponent.value()),
                Operation::Law(law, arguments) => {
                    let arguments: Vec<f64> = arguments.iter().map(get).collect();
                    results[slot] = Some((self.laws)(*law, &arguments));
                    f64::NAN
                }
                Operation::Part(law, partial) => match &results[*law] {
                    Some((value, partials)) => {
                        partial.map_or(*value, |slot| partials[slot as usize])
                    }
                    None => f64::NAN,
                },
                Operation::Table(table, order, x) => table.value(get(x), *order),
            };
            values.push(value);
        }
        function
            .outputs
            .iter()
            .map(|output| (*output, self.operand(output.value, &values)))
            .collect()
    }

    fn operand(&self, operand: Operand, values: &[f64]) -> f64 {
        match operand {
            Operand::Number(number) => number.value(),
            Operand::Symbol(symbol) => (self.symbols)(symbol),
            Operand::Constant(slot) => self.constants[slot],
            Operand::Value(slot) => values[slot],
        }
    }
}
