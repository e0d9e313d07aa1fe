//! Groups → shapes: one piece of code for all groups that compute the same from different values.
//!
//! A group is written down in a form that does not depend on where its operations stand in the function: operations in
//! the order of their depth and of hashes of what they compute, values from outside numbered as they first occur. Groups
//! with the same form are rows of one table.

use super::groups::Groups;
use super::kind::{commutes, kind};
use crate::dag::{Function, Operand, Operation, Output, Place};
use crate::symbolic::{Map, Symbol, hash};

/// A piece of straight-line code, and the places of its values in each use.
#[derive(Debug)]
pub struct Shape {
    /// The code: [`Symbol::Place`] are the values it reads, elements of its output those it leaves.
    pub function: Function,
    /// The places of each use: of the values that are read, then of those that are left.
    pub table: Vec<Vec<u32>>,
}

/// A group as a use of a shape.
pub(super) struct Member {
    pub shape: usize,
    /// The operands that it reads.
    pub reads: Vec<Operand>,
    /// Its operations, in the order of the shape.
    pub order: Vec<usize>,
}

/// The shapes, with the operations whose values they leave (as outputs), and each group as a use of one.
pub(super) fn of(function: &Function, groups: &Groups) -> (Vec<Shape>, Vec<Member>) {
    let left = values_left(function, groups);
    let mut known: Map<Vec<Operation>, usize> = Map::default();
    let mut shapes: Vec<(Vec<Operation>, Vec<bool>)> = Vec::new();
    let mut members = Vec::with_capacity(groups.members.len());
    for group in &groups.members {
        let (operations, reads, order) = Form::of(function, group);
        let next = shapes.len();
        let shape = *known.entry(operations.clone()).or_insert(next);
        if shape == next {
            shapes.push((operations, vec![false; order.len()]));
        }
        for (is_left, &slot) in shapes[shape].1.iter_mut().zip(&order) {
            *is_left |= left[slot];
        }
        members.push(Member {
            shape,
            reads,
            order,
        });
    }
    let mut uses = vec![0; shapes.len()];
    members.iter().for_each(|member| uses[member.shape] += 1);
    let mut names: Vec<Vec<Option<String>>> = vec![Vec::new(); shapes.len()];
    for member in &members {
        // Names are those of the only use: those of several would not agree.
        names[member.shape] = match uses[member.shape] {
            1 => member
                .order
                .iter()
                .map(|&slot| function.names[slot].clone())
                .collect(),
            _ => vec![None; member.order.len()],
        };
    }
    let shapes = shapes
        .into_iter()
        .zip(names)
        .map(|((operations, left), names)| {
            let left = left.iter().enumerate().filter(|(_, is_left)| **is_left);
            let outputs = left.enumerate().map(|(k, (local, _))| Output {
                sink: "t",
                place: Place::Element(k),
                value: Operand::Value(local),
            });
            Shape {
                function: Function {
                    name: function.name,
                    outputs: outputs.collect(),
                    operations,
                    names,
                },
                table: Vec::new(),
            }
        })
        .collect();
    (shapes, members)
}

/// Whether the value of an operation is used outside its group.
fn values_left(function: &Function, groups: &Groups) -> Vec<bool> {
    let mut left = vec![false; function.operations.len()];
    for (slot, operation) in function.operations.iter().enumerate() {
        operation.for_each_operand(|operand| {
            if let Operand::Value(value) = operand {
                left[value] |= groups.of[value] != groups.of[slot];
            }
        });
    }
    for output in &function.outputs {
        if let Operand::Value(value) = output.value {
            left[value] = true;
        }
    }
    left
}

/// A group on the way to its form.
struct Form<'a> {
    function: &'a Function,
    group: &'a [usize],
    /// Where an operation stands in the group.
    local: Map<usize, usize>,
    depth: Vec<u32>,
    hashes: Vec<u64>,
}

impl Form<'_> {
    /// Its operations with [`Symbol::Place`] for values from outside; these values; and the order of the operations.
    fn of(function: &Function, group: &[usize]) -> (Vec<Operation>, Vec<Operand>, Vec<usize>) {
        let local = group.iter().enumerate().map(|(at, &slot)| (slot, at));
        let mut form = Form {
            function,
            group,
            local: local.collect(),
            depth: vec![0; group.len()],
            hashes: vec![0; group.len()],
        };
        form.look_down();
        form.look_up();
        form.written()
    }

    fn inner(&self, operand: Operand) -> Option<usize> {
        match operand {
            Operand::Value(slot) => self.local.get(&slot).copied(),
            _ => None,
        }
    }

    /// Depths, and hashes of what is computed.
    fn look_down(&mut self) {
        for at in 0..self.group.len() {
            let operation = &self.function.operations[self.group[at]];
            let mut below = Vec::new();
            let mut depth = 0;
            operation.for_each_operand(|operand| match self.inner(operand) {
                Some(inner) => {
                    depth = depth.max(self.depth[inner] + 1);
                    below.push(self.hashes[inner]);
                }
                None => below.push(0),
            });
            if commutes(operation) {
                below.sort_unstable();
            }
            (self.depth[at], self.hashes[at]) = (depth, hash((kind(operation), below)));
        }
    }

    /// Adds hashes of what uses a value.
    fn look_up(&mut self) {
        let mut above = vec![0_u64; self.group.len()];
        for at in (0..self.group.len()).rev() {
            let operation = &self.function.operations[self.group[at]];
            let mut place = 0_u64;
            let own = hash((self.hashes[at], above[at]));
            operation.for_each_operand(|operand| {
                if let Some(inner) = self.inner(operand) {
                    above[inner] = above[inner].wrapping_add(hash((own, place)));
                }
                if !commutes(operation) {
                    place += 1;
                }
            });
        }
        for (own, above) in self.hashes.iter_mut().zip(above) {
            *own = hash((*own, above));
        }
    }

    fn written(&self) -> (Vec<Operation>, Vec<Operand>, Vec<usize>) {
        let mut order: Vec<usize> = (0..self.group.len()).collect();
        order.sort_by_key(|&at| (self.depth[at], self.hashes[at], at));
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
        let order = order.iter().map(|&at| self.group[at]).collect();
        (operations, reads, order)
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
