//! The form of a group: what it computes, wherever its operations stand in the function.
//!
//! Operations are in the order of their depth and of hashes of what they compute, values from outside are numbered as
//! they first occur.

use super::kind::{commutes, kind};
use crate::dag::{Function, Operand, Operation};
use crate::symbolic::{Map, Symbol, mixed};
use std::rc::Rc;

/// A group in its form.
#[derive(Debug)]
pub(super) struct Form {
    /// Equal for equal operations.
    pub number: usize,
    /// The operations, with [`Symbol::Place`] for values from outside.
    pub operations: Rc<[Operation]>,
    /// The values from outside.
    pub reads: Vec<Operand>,
    /// Where the operations stand in the function.
    pub order: Vec<usize>,
}

/// The forms of groups of a function. Groups change a little while they are joined: each form is made once.
pub(super) struct Forms<'a> {
    pub function: &'a Function,
    /// By first operation and length: of groups that agree in these the last one.
    of_groups: Map<(usize, usize), (Vec<usize>, Rc<Form>)>,
    /// By a hash of the operations, each with its number.
    numbers: Map<u64, Vec<(Rc<[Operation]>, usize)>>,
    count: usize,
    /// Where an operation stands in the group that is being written; of others anything.
    local: Vec<u32>,
}

impl<'a> Forms<'a> {
    pub(super) fn new(function: &'a Function) -> Forms<'a> {
        Forms {
            function,
            of_groups: Map::default(),
            numbers: Map::default(),
            count: 0,
            local: vec![0; function.operations.len()],
        }
    }

    /// The form of the group of these operations.
    pub(super) fn of(&mut self, group: &[usize]) -> Rc<Form> {
        let key = (group[0], group.len());
        if let Some((known, form)) = self.of_groups.get(&key)
            && known == group
        {
            return form.clone();
        }
        let form = Rc::new(self.written(group));
        self.of_groups.insert(key, (group.to_vec(), form.clone()));
        form
    }

    fn written(&mut self, group: &[usize]) -> Form {
        for (at, &slot) in group.iter().enumerate() {
            self.local[slot] = at as u32;
        }
        let mut writer = Writer {
            function: self.function,
            group,
            local: &self.local,
            depth: vec![0; group.len()],
            hashes: vec![0; group.len()],
        };
        writer.look_down();
        writer.look_up();
        let order = writer.order();
        let (operations, reads) = writer.written(&order);
        // What follows from the operations alone.
        let hashes = order.iter().map(|&at| writer.hashes[at]);
        let alike = self.numbers.entry(hashes.fold(0, mixed)).or_default();
        let (operations, number) = match alike.iter().find(|(known, _)| **known == *operations) {
            Some(known) => known.clone(),
            None => {
                alike.push((operations.into(), self.count));
                self.count += 1;
                alike[alike.len() - 1].clone()
            }
        };
        Form {
            number,
            operations,
            reads,
            order: order.iter().map(|&at| group[at]).collect(),
        }
    }
}

/// The hash of a value from outside.
const OUTSIDE: u64 = 1;

/// A group on the way to its form.
struct Writer<'a> {
    function: &'a Function,
    group: &'a [usize],
    /// Where an operation stands in the group, if it does.
    local: &'a [u32],
    depth: Vec<u32>,
    hashes: Vec<u64>,
}

impl Writer<'_> {
    fn inner(&self, operand: Operand) -> Option<usize> {
        match operand {
            Operand::Value(slot) => {
                let at = self.local[slot] as usize;
                (at < self.group.len() && self.group[at] == slot).then_some(at)
            }
            _ => None,
        }
    }

    /// Depths, and hashes of what is computed.
    fn look_down(&mut self) {
        for at in 0..self.group.len() {
            let operation = &self.function.operations[self.group[at]];
            let (which, detail) = kind(operation);
            // Mixing zeros would answer zero.
            let own = mixed(mixed(OUTSIDE, u64::from(which)), detail);
            let (mut all, mut sum) = (own, 0_u64);
            let mut depth = 0;
            operation.for_each_operand(|operand| {
                let below = match self.inner(operand) {
                    Some(inner) => {
                        depth = depth.max(self.depth[inner] + 1);
                        self.hashes[inner]
                    }
                    None => OUTSIDE,
                };
                all = mixed(all, below);
                sum = sum.wrapping_add(below);
            });
            // Operands that commute have no order.
            let hash = match commutes(operation) {
                true => mixed(own, sum),
                false => all,
            };
            (self.depth[at], self.hashes[at]) = (depth, hash);
        }
    }

    /// Adds hashes of what uses a value.
    fn look_up(&mut self) {
        let mut above = vec![0_u64; self.group.len()];
        for at in (0..self.group.len()).rev() {
            let operation = &self.function.operations[self.group[at]];
            let mut place = 0_u64;
            let own = mixed(self.hashes[at], above[at]);
            operation.for_each_operand(|operand| {
                if let Some(inner) = self.inner(operand) {
                    above[inner] = above[inner].wrapping_add(mixed(own, place));
                }
                if !commutes(operation) {
                    place += 1;
                }
            });
        }
        for (own, above) in self.hashes.iter_mut().zip(above) {
            *own = mixed(*own, above);
        }
    }

    /// The operations of the group in the order of its form.
    fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.group.len()).collect();
        order.sort_unstable_by_key(|&at| (self.depth[at], self.hashes[at], at));
        order
    }

    fn written(&self, order: &[usize]) -> (Vec<Operation>, Vec<Operand>) {
        let mut number = vec![0; order.len()];
        let mut reads: Vec<Operand> = Vec::new();
        let mut known: Map<Operand, usize> = Map::default();
        let mut operations = Vec::with_capacity(order.len());
        for (next, &at) in order.iter().enumerate() {
            number[at] = next;
            let operation = self.in_order(&self.function.operations[self.group[at]], &number);
            let read = |operand: Operand| match self.inner(operand) {
                Some(inner) => Operand::Value(number[inner]),
                None => {
                    // Equal numbers may be equal by chance, and different in the next group.
                    let place = match operand {
                        Operand::Number(_) => {
                            reads.push(operand);
                            reads.len() - 1
                        }
                        _ => *known.entry(operand).or_insert_with(|| {
                            reads.push(operand);
                            reads.len() - 1
                        }),
                    };
                    Operand::Symbol(Symbol::Place(place as u32))
                }
            };
            operations.push(mapped(&operation, read));
        }
        (operations, reads)
    }

    /// The operation with its commuting operands in an order that does not depend on the function.
    fn in_order(&self, operation: &Operation, number: &[usize]) -> Operation {
        let rank = |operand: Operand| match self.inner(operand) {
            Some(inner) => (0, number[inner]),
            None => (1, 0),
        };
        match *operation {
            Operation::Add(a, b) if rank(b) < rank(a) => Operation::Add(b, a),
            Operation::Multiply(a, b) if rank(b) < rank(a) => Operation::Multiply(b, a),
            _ => operation.clone(),
        }
    }
}

/// As [`Operation::map_operands`], with a map that counts.
fn mapped(operation: &Operation, mut map: impl FnMut(Operand) -> Operand) -> Operation {
    let mut operands = Vec::new();
    operation.for_each_operand(|operand| operands.push(map(operand)));
    let next = std::cell::Cell::new(0);
    operation.map_operands(|_| {
        next.set(next.get() + 1);
        operands[next.get() - 1]
    })
}
