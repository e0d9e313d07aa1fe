//! Operations → groups, the pieces of which code is made.

use super::kind::fingerprint;
use super::labels::Labels;
use super::shape::Member;
use super::signature;
use crate::dag::{Function, Operand, Operation};
use crate::symbolic::Map;

/// The most operations of a group: rustc needs more than proportional time for longer functions.
const LARGEST: usize = 250;

/// Long groups are cut where the fingerprint of an operation is a multiple of [`EVERY`], so that groups of the same form
/// but for a few operations are cut in the same places, and most of their pieces agree. Pieces have this length at least.
const SHORTEST: usize = 20;

/// See [`SHORTEST`]. With 6 the code of a Stewart platform is a seventh shorter than with cuts at [`LARGEST`] alone.
const EVERY: u64 = 6;

/// A group of so few operations is joined to its only user wherever that is.
const TINY: usize = 3;

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
        let ends = |last: &usize| fingerprint(function, *last).is_multiple_of(EVERY);
        let is_full = |group: usize| {
            let members = &groups.members[group];
            let length = members.len();
            length >= LARGEST || (length >= SHORTEST && members.last().is_some_and(ends))
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
    groups
}

impl Groups {
    /// Joins each group to the only other one that uses its values, so that these need no place: those of a shape all to
    /// groups of one shape, or none, so that pieces of the same form remain.
    pub(super) fn join(self, function: &Function, members: &[Member], rare: &[bool]) -> Groups {
        let count = self.members.len();
        let consumers = self.consumers(function);
        let is_rare = |group: usize| rare[members[group].shape];
        let target = |group: usize| match consumers[group] {
            Consumer::Group(to) if is_rare(to) == is_rare(group) => Some(to),
            _ => None,
        };
        // For each shape that of the groups to which its groups are joined, if they agree.
        let mut common: Vec<Option<Option<usize>>> = vec![None; rare.len()];
        for group in 0..count {
            let to = target(group).map(|to| members[to].shape);
            let common = &mut common[members[group].shape];
            *common = match *common {
                Some(before) if before != to => Some(None),
                _ => Some(to),
            };
        }
        let mut root: Vec<usize> = (0..count).collect();
        let mut size: Vec<usize> = self.members.iter().map(Vec::len).collect();
        for group in 0..count {
            let agreed = matches!(common[members[group].shape], Some(Some(_)));
            if let Some(to) = target(group)
                .filter(|_| agreed || is_rare(group) || self.members[group].len() <= TINY)
            {
                let to = find(&root, to);
                if size[group] + size[to] <= LARGEST {
                    root[group] = to;
                    size[to] += size[group];
                }
            }
        }
        self.renumbered(|group| find(&root, group))
    }

    /// For each group those that use its values.
    fn consumers(&self, function: &Function) -> Vec<Consumer> {
        let mut consumers = vec![Consumer::None; self.members.len()];
        for (slot, operation) in function.operations.iter().enumerate() {
            let to = self.of[slot];
            operation.for_each_operand(|operand| {
                if let Operand::Value(value) = operand {
                    let from = self.of[value];
                    consumers[from] = match consumers[from] {
                        same if from == to => same,
                        Consumer::None => Consumer::Group(to),
                        Consumer::Group(group) if group == to => Consumer::Group(to),
                        _ => Consumer::Several,
                    };
                }
            });
        }
        consumers
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

/// The groups that use the values of another.
#[derive(Clone, Copy, PartialEq)]
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
