//! Rows that are left out, with the joints that hold what they say.

use super::Idle;
use super::joints::JointEquations;
use crate::model::Model;
use crate::symbolic::{Graph, Symbol};
use std::collections::BTreeSet;

/// Takes the idle rows out of the joints' equations. Their multipliers are zero: what such a row could transmit is counted
/// with the joints that are coordinates.
pub(super) fn split(
    graph: &Graph,
    model: &Model,
    joints: Vec<(String, JointEquations)>,
) -> (Vec<(String, JointEquations)>, Vec<Idle>) {
    let mut idle = Vec::new();
    let split = joints.into_iter().map(|(entry, mut equations)| {
        let mut kept: Vec<Option<usize>> = Vec::new();
        let mut rows = Vec::new();
        for (slot, row) in equations.rows.into_iter().enumerate() {
            if !model.idle.contains(&(entry.clone(), slot)) {
                kept.push(Some(rows.len()));
                rows.push(row);
                continue;
            }
            kept.push(None);
            idle.push(Idle {
                name: row.name(&entry),
                entry: entry.clone(),
                follows_from: between(model, graph.symbols([row.expr])),
            });
        }
        equations.rows = rows;
        for component in &mut equations.reactions {
            let terms = component.terms.iter();
            component.terms = terms
                .filter_map(|&(row, coefficient)| Some((kept[row]?, coefficient)))
                .collect();
        }
        (entry, equations)
    });
    (split.collect(), idle)
}

/// The joints of the tree between the parts that an expression in local coordinates is about.
fn between(model: &Model, symbols: Vec<Symbol>) -> Vec<String> {
    let mut parts: BTreeSet<Option<usize>> = BTreeSet::new();
    for symbol in symbols {
        let local = match symbol {
            Symbol::LocalPosition(local)
            | Symbol::LocalVelocity(local)
            | Symbol::LocalRotation(local, _) => local,
            _ => continue,
        };
        parts.extend(
            (0..model.parts.len())
                .filter(|&part| model.parts[part].locals.contains(&local))
                .map(Some),
        );
    }
    // One part alone is held against the ground.
    if parts.len() == 1 {
        parts.insert(None);
    }
    let chains = parts.into_iter().map(|part| model.tree.chain(part));
    let chains: Vec<BTreeSet<usize>> = chains.collect();
    let shared = |joint: &usize| chains.iter().all(|chain| chain.contains(joint));
    let all: BTreeSet<usize> = chains.iter().flatten().copied().collect();
    let mut names: Vec<String> = all
        .iter()
        .filter(|joint| !shared(joint))
        .map(|&joint| model.tree.joints[joint].joint.clone())
        .collect();
    names.sort();
    names
}
