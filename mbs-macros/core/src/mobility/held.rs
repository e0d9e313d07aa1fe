//! Positions that are held, as rows beside those of the joints: do they fit together?

use super::closing::{self, Open};
use super::numbers::{self, Numbers};
use crate::derivatives;
use crate::equations::{Row, System};
use crate::model::{Held, Outline};

/// Whether a pose near the guess has all positions that are held; uncertain cases are left to assembly.
///
/// # Errors
/// No pose has them. It is about the last part of which a position is held.
pub fn held(outline: &Outline, system: &mut System) -> Result<(), Open> {
    let held: Vec<&Held> = system.held.iter().filter(|own| !own.is_velocity).collect();
    let Some(last) = held.last().map(|own| own.entry.clone()) else {
        return Ok(());
    };
    let rows: Vec<Row> = held.into_iter().map(Row::of_held).collect();
    let first = system.holonomic_rows();
    let added = first..first + rows.len();
    system.rows.splice(first..first, rows);
    let found = close(outline, system);
    system.rows.drain(added);
    found.map_err(|open| Open {
        entry: last,
        ..open
    })
}

fn close(outline: &Outline, system: &System) -> Result<(), Open> {
    let mut graph = system.graph.clone();
    let derived = derivatives::rows(&mut graph, &system.rows);
    let order = numbers::order(outline, system);
    let (numbers, guess) = Numbers::new(outline, system, &graph, &derived, &order);
    if numbers.assemble(guess.clone()).is_none() {
        closing::close(&numbers, guess)?;
    }
    Ok(())
}
