//! The messages about a start that cannot be had.

use crate::{AssemblyVerdict, HeldGap, Level, OpenRow};
use core::fmt;

/// The message of [`SimulationError::Assembly`](super::SimulationError::Assembly).
pub(super) fn write_assembly(
    out: &mut fmt::Formatter<'_>,
    verdict: &AssemblyVerdict,
) -> fmt::Result {
    write!(
        out,
        "the mechanism cannot be assembled near its declared guess; "
    )?;
    out.write_str(match verdict.worst_rows.is_empty() {
        true => "its rows have no finite values there",
        false => "these rows pull apart: ",
    })?;
    for (i, row) in verdict.worst_rows.iter().enumerate() {
        let OpenRow {
            name,
            unit,
            residual,
        } = row;
        let comma = if i > 0 { ", " } else { "" };
        let (space, unit) = in_unit(unit);
        write!(
            out,
            "{comma}`{name}` (residual {residual:.3e}{space}{unit})"
        )?;
    }
    write!(
        out,
        "; check the lengths in these joints, or start from a closer guess"
    )
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
        let comma = if i > 0 { ", " } else { "" };
        let (space, unit) = in_unit(unit);
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

/// What follows a value with this unit: a space and the unit, or nothing for numbers.
fn in_unit(unit: &str) -> (&str, &str) {
    match unit {
        "" | "1" => ("", ""),
        unit => (" ", unit),
    }
}
