//! The order in which groups are computed, and the places of values.

use super::free_places::FreePlaces;
use super::groups::Groups;
use super::shape::{Member, Shape};
use super::{Parts, Run};
use crate::dag::{Function, Operand, Output, Place};
use crate::symbolic::{Map, Set};
use std::cmp::Reverse;
use std::ops::Range;

/// A shape of fewer groups is rare.
const OFTEN: usize = 3;

/// Groups in an order in which each follows those it reads; as many groups of a shape as possible one after the other.
pub(super) fn of(
    function: &Function,
    groups: &Groups,
    mut shapes: Vec<Shape>,
    members: Vec<Member>,
    order: Vec<Vec<usize>>,
) -> Parts {
    let mut places = Places::new(function, groups, &members, &order);
    let mut runs: Vec<Run> = Vec::new();
    for batch in order {
        let shape = members[batch[0]].shape;
        let first = shapes[shape].table.len();
        let outputs = shapes[shape].function.outputs.iter();
        let values = outputs.filter(|output| matches!(output.value, Operand::Value(_)));
        places.begin_batch((values.count() * batch.len()) as u32);
        for &group in &batch {
            let member = &members[group];
            let mut row: Vec<u32> = Vec::with_capacity(member.reads.len());
            row.extend(member.reads.iter().map(|&operand| places.read(operand)));
            for output in &shapes[shape].function.outputs {
                if let Operand::Value(local) = output.value {
                    row.push(places.leave(member.form.order[local]));
                }
            }
            shapes[shape].table.push(row);
        }
        let count = batch.len();
        match runs.last_mut() {
            Some(last) if last.shape == shape => last.count += count,
            _ => runs.push(Run {
                shape,
                first,
                count,
            }),
        }
        places.end_batch();
    }
    let outputs = function.outputs.iter();
    let outputs = outputs.filter(|output| !is_absent(output));
    let outputs: Vec<_> = outputs
        .map(|output| (*output, places.read(output.value) as usize))
        .collect();
    Parts {
        inputs: places.inputs,
        shapes,
        runs,
        outputs,
        places: places.count as usize,
    }
}

/// Zeros of matrices that are written through a sink are not written.
fn is_absent(output: &Output) -> bool {
    let whole = ["points", "w", "delassus"].contains(&output.sink);
    let is_entry = matches!(output.place, Place::Entry(..) | Place::Tensor(..));
    is_entry && !whole && output.value == Operand::number(0.0)
}

/// Shapes of so few groups that a table would not make the code shorter.
pub(super) fn rare(members: &[Member], shapes: usize) -> Vec<bool> {
    let mut uses = vec![0; shapes];
    members.iter().for_each(|member| uses[member.shape] += 1);
    uses.into_iter().map(|uses| uses < OFTEN).collect()
}

/// Batches of independent groups of one shape each.
pub(super) fn ordered(groups: &Groups, members: &[Member], rare: &[bool]) -> Vec<Vec<usize>> {
    let count = groups.members.len();
    let mut waiting = vec![0_usize; count];
    let mut users: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (group, member) in members.iter().enumerate() {
        let mut read: Vec<usize> = Vec::new();
        for &operand in &member.reads {
            if let Operand::Value(value) = operand {
                read.push(groups.of[value]);
            }
        }
        read.sort_unstable();
        read.dedup();
        waiting[group] = read.len();
        read.iter().for_each(|&from| users[from].push(group));
    }
    let mut height = vec![0_u32; count];
    for group in by_dependence(&waiting, &users).into_iter().rev() {
        let above = users[group].iter().map(|&user| height[user] + 1);
        height[group] = above.max().unwrap_or(0);
    }
    let mut list = Vec::new();
    let mut ready = Ready::new(rare);
    for group in (0..count).filter(|&group| waiting[group] == 0) {
        ready.push(members[group].shape, group, height[group]);
    }
    while let Some(batch) = ready.pop() {
        for &group in &batch {
            for &user in &users[group] {
                waiting[user] -= 1;
                if waiting[user] == 0 {
                    ready.push(members[user].shape, user, height[user]);
                }
            }
        }
        list.push(batch);
    }
    list
}

/// The groups that can be computed, by shape.
struct Ready<'a> {
    groups: Vec<Vec<usize>>,
    /// For each shape with groups the length of the longest way from one of them to the end, plus one; otherwise 0.
    urgency: Vec<u32>,
    /// Whether a shape is rare.
    rare: &'a [bool],
    /// Whether the last one was.
    was_rare: bool,
}

impl Ready<'_> {
    fn new(rare: &[bool]) -> Ready<'_> {
        Ready {
            groups: vec![Vec::new(); rare.len()],
            urgency: vec![0; rare.len()],
            rare,
            was_rare: false,
        }
    }

    fn push(&mut self, shape: usize, group: usize, height: u32) {
        self.groups[shape].push(group);
        self.urgency[shape] = self.urgency[shape].max(height + 1);
    }

    /// All groups of the most urgent shape: those of less urgent ones gather in the meantime. Rare shapes follow each
    /// other, because they become one piece.
    fn pop(&mut self) -> Option<Vec<usize>> {
        let waiting = self.urgency.iter().enumerate();
        let waiting = waiting.filter(|(_, urgency)| **urgency > 0);
        let rank = |&(shape, &urgency): &(usize, &u32)| {
            let follows = self.was_rare && self.rare[shape];
            (follows, urgency, Reverse(shape))
        };
        let (shape, _) = waiting.max_by_key(rank)?;
        self.urgency[shape] = 0;
        self.was_rare = self.rare[shape];
        Some(std::mem::take(&mut self.groups[shape]))
    }
}

/// The groups, each after those it reads.
fn by_dependence(waiting: &[usize], users: &[Vec<usize>]) -> Vec<usize> {
    let mut waiting = waiting.to_vec();
    let mut list: Vec<usize> = (0..waiting.len()).filter(|&g| waiting[g] == 0).collect();
    let mut next = 0;
    while next < list.len() {
        for &user in &users[list[next]] {
            waiting[user] -= 1;
            if waiting[user] == 0 {
                list.push(user);
            }
        }
        next += 1;
    }
    list
}

/// The places of values: those of inputs are fixed, others are used again.
struct Places {
    inputs: Vec<Operand>,
    of_inputs: Map<Operand, u32>,
    of_values: Vec<Option<u32>>,
    /// After which batch a value is needed no more.
    last: Vec<Vec<usize>>,
    batch: usize,
    free: FreePlaces,
    /// Places of the batch, one after the other, so that those of alike groups grow by the same steps.
    next: Range<u32>,
    count: u32,
}

impl Places {
    fn new(
        function: &Function,
        groups: &Groups,
        members: &[Member],
        order: &[Vec<usize>],
    ) -> Places {
        let mut when = vec![0; groups.members.len()];
        for (at, batch) in order.iter().enumerate() {
            batch.iter().for_each(|&group| when[group] = at);
        }
        const ALWAYS: usize = usize::MAX;
        let mut last = vec![0; function.operations.len()];
        let mut inputs = Vec::new();
        let mut known = Set::default();
        let mut input = |operand: Operand| {
            if known.insert(operand) {
                inputs.push(operand);
            }
        };
        for (group, member) in members.iter().enumerate() {
            for &slot in &member.form.order {
                last[slot] = last[slot].max(when[group]);
            }
            for &operand in &member.reads {
                match operand {
                    Operand::Value(value) => last[value] = last[value].max(when[group]),
                    other => input(other),
                }
            }
        }
        for output in &function.outputs {
            match output.value {
                Operand::Value(value) => last[value] = ALWAYS,
                _ if is_absent(output) => {}
                other => input(other),
            }
        }
        // Entries of an argument are copied many at a time.
        inputs.sort_by_key(|operand| match *operand {
            Operand::Symbol(symbol) => (0, Some(symbol), 0),
            Operand::Constant(slot) => (1, None, slot),
            _ => (2, None, 0),
        });
        let of_inputs = inputs.iter().copied().zip(0..).collect();
        let mut by_batch = vec![Vec::new(); order.len()];
        for (value, &batch) in last.iter().enumerate() {
            if batch != ALWAYS {
                by_batch[batch].push(value);
            }
        }
        Places {
            count: inputs.len() as u32,
            inputs,
            of_inputs,
            of_values: vec![None; function.operations.len()],
            last: by_batch,
            batch: 0,
            free: FreePlaces::default(),
            next: 0..0,
        }
    }

    fn read(&self, operand: Operand) -> u32 {
        let place = match operand {
            Operand::Value(value) => self.of_values[value],
            other => self.of_inputs.get(&other).copied(),
        };
        place.expect("each value has a place before it is read")
    }

    /// Takes places for the values that a batch leaves.
    fn begin_batch(&mut self, values: u32) {
        self.next = self.free.take(values).unwrap_or_else(|| {
            let first = self.count;
            self.count += values;
            first..self.count
        });
    }

    fn leave(&mut self, value: usize) -> u32 {
        let place = self.next.next().expect("a batch has places for its values");
        self.of_values[value] = Some(place);
        place
    }

    /// The places of values that nothing needs after this batch are free for others.
    fn end_batch(&mut self) {
        for value in std::mem::take(&mut self.last[self.batch]) {
            if let Some(place) = self.of_values[value].take() {
                self.free.put(place);
            }
        }
        self.batch += 1;
    }
}
