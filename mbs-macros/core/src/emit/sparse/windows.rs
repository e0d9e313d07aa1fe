//! Columns as loops: within a loop each place is a number within a window that moves along.

use crate::dag::{Elimination, Stretch};
use std::fmt::Write;

/// Where the windows of a loop begin, and how far they reach.
pub(super) struct Window {
    /// Slot and position that count as zero.
    pub(super) slot: usize,
    pub(super) position: usize,
    /// What the names of the arrays end with.
    pub(super) part: &'static str,
}

/// Writes a column's part of a function.
pub(super) type Column = fn(&mut String, &Elimination, usize, &Window);

/// The arrays of a function: those by slot, those by position, those of both that are written to, and what is returned if
/// one is too short, which none is.
pub(super) struct Arrays<'a> {
    pub(super) slots: &'a [&'a str],
    pub(super) vectors: &'a [&'a str],
    pub(super) changed: &'a [&'a str],
    pub(super) give_up: &'a str,
}

/// The columns one after the other, as loops over windows of the arrays.
pub(super) fn stretches(
    e: &Elimination,
    arrays: &Arrays,
    backward: bool,
    column: Column,
) -> String {
    let mut loops: Vec<&[Stretch]> = e.stretches.chunk_by(|stretch, _| stretch.joined).collect();
    if backward {
        loops.reverse();
    }
    let mut out = String::new();
    for stretches in loops {
        match *stretches {
            [first, second] => pair(&mut out, e, arrays, backward, column, [first, second]),
            _ => stretches
                .iter()
                .for_each(|&stretch| single(&mut out, e, arrays, backward, column, stretch)),
        }
    }
    out
}

/// Columns of the first turn.
fn columns(stretch: Stretch, backward: bool) -> Vec<usize> {
    let mut columns: Vec<usize> = (stretch.first..stretch.first + stretch.period).collect();
    if backward {
        columns.reverse();
    }
    columns
}

fn single(
    out: &mut String,
    e: &Elimination,
    arrays: &Arrays,
    backward: bool,
    column: Column,
    stretch: Stretch,
) {
    let columns = columns(stretch, backward);
    if stretch.times == 1 {
        let all = Window {
            slot: 0,
            position: 0,
            part: "",
        };
        for position in columns {
            column(out, e, position, &all);
        }
        return;
    }
    begin_turns(out, stretch, backward);
    let window = windows(out, e, arrays, stretch, "", [0, 0]);
    for position in columns {
        column(out, e, position, &window);
    }
    out.push_str("}\n");
}

/// Two branches in one loop, a column of each in turn.
fn pair(
    out: &mut String,
    e: &Elimination,
    arrays: &Arrays,
    backward: bool,
    column: Column,
    [first, second]: [Stretch; 2],
) {
    let split = [e.columns[second.first].pivot, second.first];
    let split_at = |array: &str| match arrays.vectors.contains(&array) {
        true => split[1],
        false => split[0],
    };
    out.push_str("{\n");
    for array in arrays.slots.iter().chain(arrays.vectors) {
        let method = match arrays.changed.contains(array) {
            true => "split_at_mut",
            false => "split_at",
        };
        let _ = writeln!(
            out,
            "let ({array}_low, {array}_high) = {array}.{method}({});",
            split_at(array)
        );
    }
    begin_turns(out, first, backward);
    let low = windows(out, e, arrays, first, "_low", [0, 0]);
    let high = windows(out, e, arrays, second, "_high", split);
    let [first, second] = [first, second].map(|stretch| columns(stretch, backward));
    for turn in 0..first.len().max(second.len()) {
        for (columns, window) in [(&first, &low), (&second, &high)] {
            if let Some(&position) = columns.get(turn) {
                column(out, e, position, window);
            }
        }
    }
    out.push_str("}\n}\n");
}

fn begin_turns(out: &mut String, stretch: Stretch, backward: bool) {
    let turns = if backward { ".rev()" } else { "" };
    let _ = writeln!(out, "for turn in (0..{}_usize){turns} {{", stretch.times);
}

/// The windows of a turn; `part` is what names of the arrays end with, and `before` are the slots and positions before
/// them.
fn windows(
    out: &mut String,
    e: &Elimination,
    arrays: &Arrays,
    Stretch { first, period, .. }: Stretch,
    part: &'static str,
    before: [usize; 2],
) -> Window {
    let window = Window {
        slot: e.columns[first].pivot,
        position: first,
        part,
    };
    let (width, reach) = extent(e, first, period);
    let stride = e.columns[first + period].pivot - window.slot;
    let _ = writeln!(
        out,
        "let (slot, position) = ({} + {stride} * turn, {} + {period} * turn);",
        window.slot - before[0],
        window.position - before[1]
    );
    let all = arrays.slots.iter().map(|array| (array, "slot", width));
    let vectors = arrays.vectors.iter().map(|x| (x, "position", reach));
    for (array, from, length) in all.chain(vectors) {
        let (get, chunk) = match arrays.changed.contains(array) {
            true => ("get_mut", "first_chunk_mut"),
            false => ("get", "first_chunk"),
        };
        let _ = writeln!(
            out,
            "let Some({array}{part}) = {array}{part}.{get}({from}..).and_then(|rest| rest.{chunk}::<{length}>()) else {{ {} }};",
            arrays.give_up
        );
    }
    window
}

/// How many slots, and positions, a group of columns reaches over.
fn extent(e: &Elimination, first: usize, period: usize) -> (usize, usize) {
    let (mut slot, mut position) = (0, 0);
    for k in first..first + period {
        let column = &e.columns[k];
        slot = slot.max(column.pivot + column.below.len());
        position = position.max(k);
        for &(i, _) in &column.below {
            position = position.max(i);
            for &(j, _) in &column.below {
                slot = slot.max(e.slot(i, j));
            }
        }
    }
    (slot - e.columns[first].pivot + 1, position - first + 1)
}
