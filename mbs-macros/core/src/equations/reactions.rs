//! Joint reactions.
//!
//! The reaction of a joint with rows follows from its multipliers. A joint whose points were merged has no multiplier.
//! Its reaction is the force that the ends on the child's side need: their inertia forces minus all other forces on
//! them, in the local coordinates of the parts, in which the ends are still separate. The multiplier of an eliminated
//! row is the force that the eliminated coordinate needs.

use super::balance::Balance;
use super::rows::multipliers;
use super::system::Reaction;
use crate::dimension::Dimension;
use crate::model::TreeJoint;
use crate::schema::World;
use crate::symbolic::{Expr, Graph, Substitution, Symbol};

/// What a joint of the tree transmits: what all parts that it carries need from others.
fn tree_reactions(
    graph: &mut Graph,
    reduction: &mut Substitution,
    balance: &Balance,
    joint: &TreeJoint,
) -> Vec<Reaction> {
    let model = balance.model;
    // The force on the partner that was declared second, at its own point.
    let (held, sign) = match joint.mobilizer.forwards {
        true => (&joint.mobilizer.child, 1.0),
        false => (&joint.mobilizer.parent, -1.0),
    };
    let about = held.point.position;
    let mut sums = [[graph.zero(); 3]; 2];
    for part in model.outline.tree.carried_by(joint.child) {
        let wrench = balance.wrench(graph, &model.outline.parts[part], about);
        for (sum, part) in sums.iter_mut().zip(wrench) {
            *sum = graph.vector_add(*sum, part);
        }
    }
    let names = [["fx", "fy", "fz"], ["tx", "ty", "tz"]];
    let dimensions = [Dimension::FORCE, Dimension::TORQUE];
    let kinds = if joint.mobilizer.frees_rotation() {
        1
    } else {
        2
    };
    let mut reactions = Vec::new();
    for kind in 0..kinds {
        // In the plane there is one torque.
        let (components, names) = match (kind, model.outline.world) {
            (1, World::Planar) => (2..3, ["", "", "torque"]),
            _ => (0..model.outline.world.dimension(), names[kind]),
        };
        for k in components {
            let signed = graph.scale(sign, sums[kind][k]);
            reactions.push(Reaction {
                joint: joint.joint.clone(),
                component: names[k].to_owned(),
                unit: dimensions[kind].unit(),
                expr: graph.substitute(signed, reduction),
            });
        }
    }
    reactions
}

/// The reactions of all joints: of merged ones, of those of the tree, and of those with rows.
pub(super) fn derive(
    graph: &mut Graph,
    reduction: &mut Substitution,
    balance: &Balance,
) -> Vec<Reaction> {
    let dimension = balance.model.outline.world.dimension();
    for (index, multiplier) in balance.recovered(graph).into_iter().enumerate() {
        let multiplier = graph.substitute(multiplier, reduction);
        reduction.insert(balance.multiplier(index), multiplier);
    }
    let mut reactions = Vec::new();
    for joint in &balance.model.merged {
        // The child's side, or the parent's side with the opposite sign where the child is held by the ground.
        let (ends, sign) = if joint.child.is_empty() {
            (&joint.parent, -1.0)
        } else {
            (&joint.child, 1.0)
        };
        for (axis, component) in ["fx", "fy", "fz"].into_iter().enumerate().take(dimension) {
            let terms: Vec<Expr> = ends
                .iter()
                .map(|end| balance.needed(graph, end + axis as u32))
                .collect();
            let sum = graph.sum(terms);
            let signed = graph.scale(sign, sum);
            let expr = graph.substitute(signed, reduction);
            reactions.push(Reaction {
                joint: joint.joint.clone(),
                component: component.to_owned(),
                unit: Dimension::FORCE.unit(),
                expr,
            });
        }
    }
    for joint in &balance.model.outline.tree.joints {
        reactions.extend(tree_reactions(graph, reduction, balance, joint));
    }
    let indices = multipliers(balance.model, balance.rows.len());
    for (index, (name, joint)) in balance.model.joints.iter().enumerate() {
        let several = |name: &str| joint.reactions.iter().filter(|c| c.name == name).count() > 1;
        for (slot, component) in joint.reactions.iter().enumerate() {
            let terms: Vec<Expr> = component
                .terms
                .iter()
                .filter_map(|&(row, coefficient)| {
                    let multiplier = indices.get(&(index, row))?;
                    let multiplier = graph.symbol(Symbol::Multiplier(*multiplier));
                    Some(graph.mul(coefficient, multiplier))
                })
                .collect();
            let sum = graph.sum(terms);
            let expr = graph.substitute(sum, reduction);
            let unit = component.dimension.unit();
            reactions.push(Reaction {
                joint: name.clone(),
                // As the rows of the same entry.
                component: match several(component.name) {
                    true => format!("{}[{slot}]", component.name),
                    false => component.name.to_owned(),
                },
                unit,
                expr,
            });
        }
    }
    reactions
}
