//! What each operation depends on, and what it serves: sets of labels.
//!
//! Along each path of operations the first set grows and the other two shrink. Operations with equal sets are therefore
//! a group that no path leaves and enters again, and the groups have an order.

use super::labels::Labels;
use crate::dag::{Function, Operand, Operation};
use crate::symbolic::Map;

/// The labels that an operation depends on, those of the rows it serves, and those of the columns.
pub(super) type Signature = [u32; 3];

pub(super) fn of(function: &Function, labels: &Labels) -> Vec<Signature> {
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
    signatures
}

const EMPTY: u32 = 0;

/// Sets of labels, each known by a number.
#[derive(Default)]
struct Sets {
    /// The labels as bits.
    list: Vec<Vec<u64>>,
    index: Map<Vec<u64>, u32>,
    unions: Map<(u32, u32), u32>,
}

impl Sets {
    fn number(&mut self, bits: Vec<u64>) -> u32 {
        if self.list.is_empty() {
            self.list.push(Vec::new());
            self.index.insert(Vec::new(), EMPTY);
        }
        if let Some(&known) = self.index.get(&bits) {
            return known;
        }
        let next = self.list.len() as u32;
        self.list.push(bits.clone());
        self.index.insert(bits, next);
        next
    }

    fn of_label(&mut self, label: u32) -> u32 {
        let mut bits = vec![0; label as usize / 64 + 1];
        bits[label as usize / 64] = 1 << (label % 64);
        self.number(bits)
    }

    fn union(&mut self, a: u32, b: u32) -> u32 {
        if a == b || b == EMPTY {
            return a;
        }
        if a == EMPTY {
            return b;
        }
        let key = (a.min(b), a.max(b));
        if let Some(&known) = self.unions.get(&key) {
            return known;
        }
        let (a, b) = (&self.list[a as usize], &self.list[b as usize]);
        let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
        let mut bits = long.clone();
        bits.iter_mut()
            .zip(short)
            .for_each(|(word, other)| *word |= other);
        let number = self.number(bits);
        self.unions.insert(key, number);
        number
    }
}
