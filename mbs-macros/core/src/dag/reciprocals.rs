//! Several divisions by the same value → one division and multiplications.
//!
//! A division takes as long as several multiplications and does not overlap with others; the forces of a spring divide
//! by its length a dozen times. The results differ by an ulp.

use super::{Function, Operand, Operation};
use crate::symbolic::Map;

/// Divides by each denominator at most once.
pub(super) fn share_reciprocals(function: Function) -> Function {
    let mut divisions: Map<Operand, usize> = Map::default();
    let mut shared = 0;
    for operation in &function.operations {
        if let Operation::Divide(_, denominator) = operation {
            let count = divisions.entry(*denominator).or_insert(0);
            *count += 1;
            shared += usize::from(*count == 2);
        }
    }
    if shared == 0 {
        return function;
    }

    let mut operations = Vec::with_capacity(function.operations.len() + shared);
    let mut names = Vec::with_capacity(operations.capacity());
    // Where each value went, and the reciprocal of each denominator once it was needed.
    let mut moved: Vec<usize> = Vec::with_capacity(function.operations.len());
    let mut reciprocals: Map<Operand, usize> = Map::default();
    for (operation, name) in function.operations.iter().zip(&function.names) {
        let operation = match operation {
            Operation::Divide(numerator, denominator)
                if divisions.get(denominator).is_some_and(|&count| count > 1) =>
            {
                let reciprocal = match reciprocals.get(denominator) {
                    Some(&slot) => slot,
                    None => {
                        let one = Operand::number(1.0);
                        operations.push(Operation::Divide(one, relocate(*denominator, &moved)));
                        names.push(match denominator {
                            Operand::Value(slot) => function.names[*slot]
                                .as_ref()
                                .map(|name| format!("inverse_{name}")),
                            _ => None,
                        });
                        reciprocals.insert(*denominator, operations.len() - 1);
                        operations.len() - 1
                    }
                };
                if *numerator == Operand::number(1.0) {
                    moved.push(reciprocal);
                    continue;
                }
                Operation::Multiply(relocate(*numerator, &moved), Operand::Value(reciprocal))
            }
            other => other.map_operands(|operand| relocate(operand, &moved)),
        };
        operations.push(operation);
        names.push(name.clone());
        moved.push(operations.len() - 1);
    }
    let mut outputs = function.outputs;
    for output in &mut outputs {
        output.value = relocate(output.value, &moved);
    }
    Function {
        name: function.name,
        operations,
        names,
        outputs,
    }
}

fn relocate(operand: Operand, moved: &[usize]) -> Operand {
    match operand {
        Operand::Value(slot) => Operand::Value(moved[slot]),
        other => other,
    }
}
