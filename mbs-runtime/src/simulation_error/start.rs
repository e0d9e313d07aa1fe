//! The messages about a start, or a change during a run, that cannot be had.

use crate::{AssemblyVerdict, HeldGap, Level, OpenRow};
use core::fmt;

/// The message of [`SimulationError::Assembly`](super::SimulationError::Assembly).
pub(super) fn write_assembly(
    out: &mut fmt::Formatter<'_>,
    verdict: &AssemblyVerdict,
) -> fmt::Result {
    out.write_str("the mechanism cannot be assembled near its declared guess; ")?;
    write_open_rows(out, &verdict.worst_rows)?;
    out.write_str("; check the lengths in these joints, or start from a closer guess")
}

/// The message of [`SimulationError::NoPose`](super::SimulationError::NoPose).
pub(super) fn write_no_pose(
    out: &mut fmt::Formatter<'_>,
    changed: &str,
    verdict: &AssemblyVerdict,
) -> fmt::Result {
    write!(out, "no pose near the present one fits these {changed}; ")?;
    write_open_rows(out, &verdict.worst_rows)?;
    write!(
        out,
        "; the {changed} keep their values: give others, nearer to the present ones"
    )
}

/// Rows that are not satisfied, or those of them that have no values.
fn write_open_rows(out: &mut fmt::Formatter<'_>, rows: &[OpenRow]) -> fmt::Result {
    if rows.is_empty() {
        return out.write_str("the rows have no finite values there");
    }
    let has_no_value = |row: &&OpenRow| !row.residual.is_finite();
    if rows.iter().any(|row| has_no_value(&row)) {
        out.write_str("these rows have no finite values there: ")?;
        for (i, row) in rows.iter().filter(has_no_value).enumerate() {
            write!(out, "{}`{}`", comma(i), row.name)?;
        }
        return Ok(());
    }
    out.write_str("these rows pull apart: ")?;
    for (i, row) in rows.iter().enumerate() {
        let OpenRow {
            name,
            unit,
            residual,
        } = row;
        let (comma, (space, unit)) = (comma(i), in_unit(unit));
        write!(
            out,
            "{comma}`{name}` (residual {residual:.3e}{space}{unit})"
        )?;
    }
    Ok(())
}

/// The message of [`SimulationError::Held`](super::SimulationError::Held).
pub(super) fn write_held(
    out: &mut fmt::Formatter<'_>,
    level: Level,
    held: &[String],
    open: &[HeldGap],
    degrees_of_freedom: usize,
) -> fmt::Result {
    let what = match level {
        Level::Position => "positions",
        Level::Velocity => "velocities",
    };
    write!(out, "the {what} that are held cannot all be had: ")?;
    match open.is_empty() {
        true => write!(out, "`{}`", held.join("`, `"))?,
        false => out.write_str("in the nearest start ")?,
    }
    for (i, held) in open.iter().enumerate() {
        let HeldGap {
            name, unit, gap, ..
        } = held;
        let (comma, (space, unit)) = (comma(i), in_unit(unit));
        write!(out, "{comma}`{name}` is off by {gap:.3e}{space}{unit}")?;
    }
    match (degrees_of_freedom, held.len()) {
        (0, _) => out.write_str(
            "; the joints leave nothing free that could be held: declare these values as guesses",
        ),
        (most, count) if count > most => write!(
            out,
            "; {count} values are held, and the joints leave {most} free: hold {most} at most, and declare the others as guesses"
        ),
        _ if open.iter().any(|held| held.is_constant) => {
            let mut constant = open.iter().filter(|held| held.is_constant);
            let name = constant.next().map_or("", |held| &held.name);
            write!(
                out,
                "; `{name}` does not change near the guess: declare another guess, or this value as one"
            )
        }
        _ => out.write_str(
            "; the joints do not allow these values together: change one, or declare it as a guess",
        ),
    }
}

/// What stands before an item of a list.
fn comma(item: usize) -> &'static str {
    if item > 0 { ", " } else { "" }
}

/// What follows a value with this unit: a space and the unit, or nothing for numbers.
fn in_unit(unit: &str) -> (&str, &str) {
    match unit {
        "" | "1" => ("", ""),
        unit => (" ", unit),
    }
}
