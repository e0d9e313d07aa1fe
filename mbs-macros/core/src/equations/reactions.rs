//! Joint reactions.
//!
//! A joint with rows transmits what its multipliers say. A joint that the reduction dissolved has no multiplier; what it
//! transmits is what the ends on the child's side need from their surroundings: inertia minus everything else that acts
//! on them, taken in the parts' own coordinates, where the ends are still apart.

use super::forces::Load;
use super::inertia::LocalMass;
use super::joints::JointEquations;
use super::{Reaction, Row, row_indices};
use crate::model::{Dimension, MergedJoint};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};

/// Everything that acts on the parts, in their own coordinates.
pub(super) struct Balance<'a> {
    pub inertia: &'a LocalMass,
    pub potential: Expr,
    pub loads: &'a [Load],
    pub rows: &'a [Row],
    /// Components of a point.
    pub dimension: usize,
}

impl Balance<'_> {
    /// The force that local coordinate `local` needs from joints: M s̈ + ∂V/∂s − Q − Aᵀλ. (The ends of parts have
    /// constant mass, so that no velocity terms occur.)
    fn needed(&self, graph: &mut Graph, local: u32) -> Expr {
        let mut terms = Vec::new();
        for (&(_, other), &mass) in self.inertia.range((local, 0)..=(local, u32::MAX)) {
            let acceleration = graph.symbol(Symbol::LocalAcceleration(other));
            terms.push(graph.mul(mass, acceleration));
        }
        terms.push(graph.derivative(self.potential, Symbol::LocalPosition(local)));
        for load in self.loads {
            let lever = graph.derivative(load.rate, Symbol::LocalVelocity(local));
            let force = graph.mul(load.force, lever);
            terms.push(graph.neg(force));
        }
        for (index, row) in self.rows.iter().enumerate() {
            let by = if row.kind.is_holonomic() {
                Symbol::LocalPosition(local)
            } else {
                Symbol::LocalVelocity(local)
            };
            let slope = graph.derivative(row.local, by);
            let multiplier = graph.symbol(Symbol::Multiplier(index as u32));
            let force = graph.mul(slope, multiplier);
            terms.push(graph.neg(force));
        }
        graph.sum(terms)
    }
}

pub(super) fn derive(
    graph: &mut Graph,
    reduction: &mut Substitution,
    joints: &[(String, JointEquations)],
    merged: &[MergedJoint],
    balance: &Balance,
) -> Vec<Reaction> {
    let dimension = balance.dimension;
    let mut reactions = Vec::new();
    for joint in merged {
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
    let indices = row_indices(joints);
    for (joint, (name, equations)) in joints.iter().enumerate() {
        let several = |name: &str| {
            equations
                .reactions
                .iter()
                .filter(|c| c.name == name)
                .count()
                > 1
        };
        for (slot, component) in equations.reactions.iter().enumerate() {
            let terms: Vec<Expr> = component
                .terms
                .iter()
                .map(|&(row, coefficient)| {
                    let multiplier = graph.symbol(Symbol::Multiplier(indices[&(joint, row)]));
                    graph.mul(coefficient, multiplier)
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
