//! Operations → groups, the pieces of which code is made.

use super::labels::Labels;
use super::shape::kind;
use super::signature;
use crate::dag::{Function, Operand, Operation};
use crate::symbolic::{Map, hash};

/// The most operations of a group.
const LARGEST: usize = 250;
const MIN: usize = 20;
const EVERY: u64 = 6;

/// The groups of a function.
pub(super) struct Groups {
    /// The operations of each, in order.
    pub members: Vec<Vec<usize>>,
    /// The group of each operation.
    pub of: Vec<usize>,
}

pub(super) fn of(function: &Function, labels: &Labels) -> Groups {
    let signatures = signature::of(function, labels);
    let mut known: Map<signature::Signature, usize> = Map::default();
    let mut groups = Groups {
        members: Vec::new(),
        of: Vec::with_capacity(signatures.len()),
    };
    for (slot, signature) in signatures.into_iter().enumerate() {
        let mut group = *known.entry(signature).or_insert(usize::MAX);
        let is_full = |group: usize| {
            let members = &groups.members[group];
            let last = members
                .last()
                .map_or(0, |&last| fingerprint(function, last));
            members.len() >= LARGEST || (members.len() >= MIN && last % EVERY == 0)
        };
        // A part of a law stays with it, whatever the size.
        if let Operation::Part(law, _) = function.operations[slot] {
            group = groups.of[law];
        } else if group == usize::MAX || is_full(group) {
            group = groups.members.len();
            groups.members.push(Vec::new());
            known.insert(signature, group);
        }
        groups.members[group].push(slot);
        groups.of.push(group);
    }
    groups.join(function)
}

impl Groups {
    /// Joins each group to the only other one that uses its values, so that these need no place.
    fn join(self, function: &Function) -> Groups {
        let count = self.members.len();
        let mut consumer = vec![Consumer::None; count];
        for (slot, operation) in function.operations.iter().enumerate() {
            let to = self.of[slot];
            operation.for_each_operand(|operand| {
                if let Operand::Value(value) = operand {
                    let from = self.of[value];
                    consumer[from] = match consumer[from] {
                        same if from == to => same,
                        Consumer::None => Consumer::Group(to),
                        Consumer::Group(group) if group == to => Consumer::Group(to),
                        _ => Consumer::Several,
                    };
                }
            });
        }
        let mut root: Vec<usize> = (0..count).collect();
        let mut size: Vec<usize> = self.members.iter().map(Vec::len).collect();
        for group in 0..count {
            if let Consumer::Group(to) = consumer[group] {
                let to = find(&root, to);
                if size[group] + size[to] <= LARGEST {
                    root[group] = to;
                    size[to] += size[group];
                }
            }
        }
        self.renumbered(|group| find(&root, group))
    }

    /// Joins the rare groups that follow each other in an order of computation.
    pub(super) fn gather(self, order: &[Vec<usize>], rare: impl Fn(usize) -> bool) -> Groups {
        let mut root: Vec<usize> = (0..self.members.len()).collect();
        let mut open: Option<(usize, usize)> = None;
        for &group in order.iter().flatten() {
            let length = self.members[group].len();
            open = match open {
                _ if !rare(group) => None,
                Some((first, size)) if size + length <= LARGEST => {
                    root[group] = first;
                    Some((first, size + length))
                }
                _ => Some((group, length)),
            };
        }
        self.renumbered(|group| root[group])
    }

    fn renumbered(self, root: impl Fn(usize) -> usize) -> Groups {
        let mut numbers: Map<usize, usize> = Map::default();
        let mut groups = Groups {
            members: Vec::new(),
            of: Vec::with_capacity(self.of.len()),
        };
        for (slot, &group) in self.of.iter().enumerate() {
            let next = groups.members.len();
            let number = *numbers.entry(root(group)).or_insert(next);
            if number == next {
                groups.members.push(Vec::new());
            }
            groups.members[number].push(slot);
            groups.of.push(number);
        }
        groups
    }
}

/// What an operation and its operands are, whatever their values.
fn fingerprint(function: &Function, slot: usize) -> u64 {
    let mut seen = vec![kind(&function.operations[slot])];
    function.operations[slot].for_each_operand(|operand| {
        if let Operand::Value(v) = operand {
            seen.push(kind(&function.operations[v]))
        }
    });
    seen.sort_unstable();
    hash(seen) >> 20
}

/// The groups that use the values of another.
#[derive(Clone, Copy)]
enum Consumer {
    None,
    Group(usize),
    Several,
}

fn find(root: &[usize], mut group: usize) -> usize {
    while root[group] != group {
        group = root[group];
    }
    group
}
