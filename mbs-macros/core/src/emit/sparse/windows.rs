//! Columns as loops: within a loop each place is a number within a window that moves along.

use crate::dag::{Elimination, Stretch};
use std::fmt::Write;

/// Where the windows of a loop begin, and how far they reach.
pub(super) struct Window {
    /// Slot and position that count as zero.
    pub(super) slot: usize,
    pub(super) position: usize,
}

/// Writes a column's part of a function.
pub(super) type Column = fn(&mut String, &Elimination, usize, &Window);

/// The stretches one after the other, each as a loop over windows of the arrays; those in `changed` are written to.
pub(super) fn stretches(
    e: &Elimination,
    arrays: &[&str],
    vectors: &[&str],
    changed: &[&str],
    backward: bool,
    give_up: &str,
    column: Column,
) -> String {
    let mut out = String::new();
    let mut list: Vec<Stretch> = e.stretches.clone();
    if backward {
        list.reverse();
    }
    for Stretch {
        first,
        period,
        times,
    } in list
    {
        let mut columns: Vec<usize> = (first..first + period).collect();
        if backward {
            columns.reverse();
        }
        if times == 1 {
            let all = Window {
                slot: 0,
                position: 0,
            };
            for position in columns {
                column(&mut out, e, position, &all);
            }
            continue;
        }
        let window = Window {
            slot: e.columns[first].pivot,
            position: first,
        };
        let (width, reach) = extent(e, first, period);
        let turns = if backward { ".rev()" } else { "" };
        let stride = e.columns[first + period].pivot - window.slot;
        let _ = writeln!(
            out,
            "for turn in (0..{times}_usize){turns} {{ let (slot, position) = ({} + {stride} * turn, {first} + {period} * turn);",
            window.slot
        );
        let all = arrays.iter().map(|array| (array, "slot", width));
        for (array, from, length) in all.chain(vectors.iter().map(|x| (x, "position", reach))) {
            let (get, chunk) = match changed.contains(array) {
                true => ("get_mut", "first_chunk_mut"),
                false => ("get", "first_chunk"),
            };
            let _ = writeln!(
                out,
                "let Some({array}) = {array}.{get}({from}..).and_then(|rest| rest.{chunk}::<{length}>()) else {{ {give_up} }};"
            );
        }
        for position in columns {
            column(&mut out, e, position, &window);
        }
        out.push_str("}\n");
    }
    out
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
