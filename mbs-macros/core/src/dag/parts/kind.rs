//! What an operation is, without its operands: groups of the same form are found by it.

use crate::dag::{Function, Operand, Operation};
use crate::symbolic::hash;

/// Different for different operations.
pub(super) fn kind(operation: &Operation) -> (u8, u64) {
    match operation {
        Operation::Add(..) => (0, 0),
        Operation::Subtract(..) => (1, 0),
        Operation::Multiply(..) => (2, 0),
        Operation::Divide(..) => (3, 0),
        Operation::Negate(_) => (4, 0),
        Operation::PivotInverse(..) => (5, 0),
        Operation::Call(function, _) => (6, *function as u64),
        Operation::Atan2(..) => (7, 0),
        Operation::Larger(..) => (12, 0),
        Operation::Power(_, exponent) => (8, exponent.value().to_bits()),
        Operation::Law(law, arguments) => (9, u64::from(*law) << 32 | arguments.len() as u64),
        Operation::Table(table, order, _) => (11, (table.index as u64) << 8 | *order as u8 as u64),
        Operation::Part(_, partial) => (10, partial.map_or(0, |p| u64::from(p) + 1)),
    }
}

/// Whether the operands can change places.
pub(super) fn commutes(operation: &Operation) -> bool {
    matches!(operation, Operation::Add(..) | Operation::Multiply(..))
}

/// A number that depends on what an operation and those it uses are, not on where they stand.
pub(super) fn fingerprint(function: &Function, slot: usize) -> u64 {
    let mut kinds = vec![kind(&function.operations[slot])];
    function.operations[slot].for_each_operand(|operand| {
        if let Operand::Value(value) = operand {
            kinds.push(kind(&function.operations[value]));
        }
    });
    kinds.sort_unstable();
    // The high bits are the well mixed ones.
    hash(kinds) >> 20
}
