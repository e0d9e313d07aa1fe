//! What each operation depends on, and what it serves: sets of labels.
//!
//! Along each path of operations the first set grows and the other two shrink. Operations with equal sets are therefore
//! a group that no path leaves and enters again, and the groups have an order.

use super::labels::Labels;
use super::sets::{EMPTY, Sets};
use crate::dag::{Function, Operand, Operation};

/// The labels that an operation depends on, those of the rows it serves, and those of the columns.
pub(super) type Signature = [u32; 3];

pub(super) fn of(function: &Function, labels: &Labels) -> Vec<Signature> {
    with_sets(function, labels).0
}

/// The same, and the sets.
pub(super) fn with_sets(function: &Function, labels: &Labels) -> (Vec<Signature>, Sets) {
    let mut sets = Sets::default();
    let mut signatures: Vec<Signature> = vec![[EMPTY; 3]; function.operations.len()];
    for (slot, operation) in function.operations.iter().enumerate() {
        let mut set = EMPTY;
        operation.for_each_operand(|operand| {
            let other = match operand {
                Operand::Value(value) => signatures[value][0],
                Operand::Symbol(symbol) => sets.of_label(labels.of_symbol(symbol)),
                _ => EMPTY,
            };
            set = sets.union(set, other);
        });
        signatures[slot][0] = set;
    }
    for output in &function.outputs {
        if let Operand::Value(value) = output.value {
            for (k, label) in labels.of_output(output).into_iter().enumerate() {
                let label = sets.of_label(label);
                signatures[value][k + 1] = sets.union(signatures[value][k + 1], label);
            }
        }
    }
    for slot in (0..function.operations.len()).rev() {
        let served = signatures[slot];
        function.operations[slot].for_each_operand(|operand| {
            if let Operand::Value(value) = operand {
                for k in 1..3 {
                    signatures[value][k] = sets.union(signatures[value][k], served[k]);
                }
            }
        });
    }
    // A law and its parts stay together: its result is no number.
    for (slot, operation) in function.operations.iter().enumerate() {
        if let Operation::Part(law, _) = operation {
            signatures[slot] = signatures[*law];
        }
    }
    (signatures, sets)
}
