//! The result of the maps of stability for stiff springs.

use super::data::{Data, Table};
use super::markdown::paragraph;
use crate::laboratory::outcome::Outcome;
use crate::laboratory::stability::Cell;

const FILE: &str = "stability.csv";
const MAP: &str = "stiff-spring";
const TOLERANT: &str = "two-level tolerance";

/// Where the two-level method of each order fails beside a stiff spring.
pub fn sentence(data: &Data) -> Result<String, String> {
    let results = data.table(FILE)?;
    let orders = ["2", "4", "6", "8"];
    let orders = orders.map(|order| {
        let (failed, all) = failures(&results, Some(MAP), &format!("two-level {order}"))?;
        Ok::<_, String>(match failed.as_slice() {
            [] => format!("order {order} passes all {all}"),
            failed => format!("order {order} fails at {}", failed.join(", ")),
        })
    });
    let orders = orders.into_iter().collect::<Result<Vec<_>, _>>()?;
    let (failed, all) = failures(&results, None, TOLERANT)?;
    let tolerant = match failed.len() {
        0 => format!("passes all {all} cells of all maps"),
        failed => format!("fails in {failed} of the {all} cells of all maps"),
    };
    Ok(paragraph(&format!(
        "With a stiff spring and constant steps the two-level method fails at some stiffness: with a step of 0.01 s and ω h = 0.01, \
         0.1, …, 1e4 (ω² = stiffness / mass) {}. With a tolerance it {tolerant} ([the maps](book/src/results/stability.md)).",
        orders.join(", ")
    )))
}

/// The columns of the cells that failed, and how many cells there are that ran to an end.
fn failures(
    results: &Table,
    map: Option<&str>,
    method: &str,
) -> Result<(Vec<String>, usize), String> {
    let own = |row: &&Vec<String>| map.is_none_or(|map| row[0] == map) && row[1] == method;
    let cells: Vec<Cell> = results
        .rows
        .iter()
        .filter(own)
        .filter_map(Cell::read)
        .filter(|cell| cell.outcome == Outcome::Ok || cell.outcome.is_failure())
        .collect();
    if cells.is_empty() {
        return Err(format!("{FILE} has no cells of `{method}`"));
    }
    let failed = cells.iter().filter(|cell| cell.outcome.is_failure());
    let name = |cell: &Cell| match cell.column < 1e3 {
        true => cell.column.to_string(),
        false => format!("{:e}", cell.column),
    };
    Ok((failed.map(name).collect(), cells.len()))
}
