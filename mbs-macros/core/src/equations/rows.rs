//! The rows that conditions leave, and the multiplier of each.

use super::system::{Row, RowKind};
use crate::dimension::Dimension;
use crate::model::elements::joint::{Joint, Level};
use crate::model::{Model, Solved};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// The status of a row of a joint.
enum RowStatus {
    Stays,
    /// It is zero in every pose, and left out.
    Vacuous,
    /// It was solved, as which one.
    Solved(usize),
}

fn row_status(model: &Model, entry: &str, slot: usize) -> RowStatus {
    match model.solved.position(entry, slot) {
        Some(position) => RowStatus::Solved(position),
        None if model.vacuous.contains(&(entry.to_owned(), slot)) => RowStatus::Vacuous,
        None => RowStatus::Stays,
    }
}

/// All rows that stay, holonomic ones first, each in local and in generalized coordinates.
pub(super) fn rows(graph: &mut Graph, reduction: &mut Substitution, model: &Model) -> Vec<Row> {
    let mut list = Vec::new();
    for level in [Level::Position, Level::Velocity] {
        for (entry, joint) in &model.joints {
            for (slot, row) in joint.conditions.iter().enumerate() {
                if row.level != level || !matches!(row_status(model, entry, slot), RowStatus::Stays)
                {
                    continue;
                }
                let expr = graph.substitute(row.expr, reduction);
                let kind = match level {
                    Level::Velocity => RowKind::Nonholonomic,
                    Level::Position if graph.depends_on(expr, is_prescribed) => RowKind::Rheonomic,
                    Level::Position => RowKind::Holonomic,
                };
                let name = row.name(entry);
                let unit = unit_of(row.dimension, level);
                list.push(Row {
                    name,
                    entry: entry.clone(),
                    kind,
                    unit,
                    expr,
                    local: row.expr,
                });
            }
        }
    }
    list
}

/// What moves a row without a motion of the mechanism.
fn is_prescribed(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Time | Symbol::Input(_))
}

fn unit_of(dimension: Option<Dimension>, level: Level) -> String {
    match (dimension, level) {
        (Some(Dimension::NONE), Level::Position) => "rad".to_owned(),
        (Some(dimension), _) => dimension.unit(),
        (None, _) => String::new(),
    }
}

/// The rows that were solved, in local coordinates.
pub(super) fn solved_rows(joints: &[(String, Joint)], solved: &Solved) -> Vec<Expr> {
    let rows = solved.rows.iter().filter_map(|(joint, slot)| {
        let (_, joint) = joints.iter().find(|(name, _)| name == joint)?;
        Some(joint.conditions.get(*slot)?.expr)
    });
    rows.collect()
}

/// The multiplier of each row of each joint, (joint, its row): the index among all rows, and after them among those
/// that were solved. A row that is left out has none: its force is a part of the reactions of the joints that are
/// coordinates.
pub(super) fn multipliers(model: &Model, rows: usize) -> BTreeMap<(usize, usize), u32> {
    let mut indices = BTreeMap::new();
    let mut next = 0;
    for level in [Level::Position, Level::Velocity] {
        for (index, (name, joint)) in model.joints.iter().enumerate() {
            for (slot, row) in joint.conditions.iter().enumerate() {
                if row.level != level {
                    continue;
                }
                let multiplier = match row_status(model, name, slot) {
                    RowStatus::Solved(position) => rows + position,
                    RowStatus::Vacuous => continue,
                    RowStatus::Stays => {
                        next += 1;
                        next - 1
                    }
                };
                indices.insert((index, slot), multiplier as u32);
            }
        }
    }
    indices
}
