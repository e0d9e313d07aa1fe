//! Rows that are left out, and the joints whose coordinates satisfy them.

use super::system::VacuousRow;
use crate::model::Model;
use crate::symbolic::{Graph, Symbol};
use std::collections::BTreeSet;

/// The vacuous rows of all joints.
pub(super) fn rows(graph: &Graph, model: &Model) -> Vec<VacuousRow> {
    let mut vacuous = Vec::new();
    for (entry, joint) in &model.joints {
        for (slot, row) in joint.conditions.iter().enumerate() {
            if model.vacuous.contains(&(entry.clone(), slot)) {
                vacuous.push(VacuousRow {
                    name: row.name(entry),
                    entry: entry.clone(),
                    follows_from: between(model, graph.symbols([row.expr])),
                });
            }
        }
    }
    vacuous
}

/// The joints of the tree between the parts that an expression in local coordinates is about.
fn between(model: &Model, symbols: Vec<Symbol>) -> Vec<String> {
    let outline = &model.outline;
    let mut parts: BTreeSet<Option<usize>> = BTreeSet::new();
    for symbol in symbols {
        let local = match symbol {
            Symbol::LocalPosition(local)
            | Symbol::LocalVelocity(local)
            | Symbol::LocalRotation(local, _) => local,
            _ => continue,
        };
        parts.extend(
            (0..outline.parts.len())
                .filter(|&part| outline.parts[part].locals.contains(&local))
                .map(Some),
        );
    }
    // One part alone is held against the ground.
    if parts.len() == 1 {
        parts.insert(None);
    }
    let chains = parts.into_iter().map(|part| outline.tree.chain(part));
    let chains: Vec<BTreeSet<usize>> = chains.collect();
    let shared = |joint: &usize| chains.iter().all(|chain| chain.contains(joint));
    let all: BTreeSet<usize> = chains.iter().flatten().copied().collect();
    let mut names: Vec<String> = all
        .iter()
        .filter(|joint| !shared(joint))
        .map(|&joint| outline.tree.joints[joint].joint.clone())
        .collect();
    names.sort();
    names
}
