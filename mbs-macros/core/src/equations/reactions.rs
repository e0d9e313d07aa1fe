//! Joint reactions.
//!
//! A joint with rows transmits what its multipliers say. A joint that the reduction dissolved has no multiplier; what it
//! transmits is what the ends on the child's side need from their surroundings: inertia minus everything else that acts
//! on them, taken in the parts' own coordinates, where the ends are still apart.

use super::forces::Load;
use super::inertia::{LocalMass, center_of};
use super::joints::JointEquations;
use super::{Reaction, Row, row_indices};
use crate::model::{Dimension, MergedJoint, Model, Part, Representation, TreeJoint, Vector};
use crate::schema::World;
use crate::symbolic::{Expr, Graph, Substitution, Symbol};

/// Everything that acts on the parts, in their own coordinates.
pub(super) struct Balance<'a> {
    pub inertia: &'a LocalMass,
    pub potential: Expr,
    pub loads: &'a [Load],
    pub rows: &'a [Row],
    pub model: &'a Model,
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

    /// Force and torque about a point that a part needs from joints, in the ground's axes.
    fn wrench(&self, graph: &mut Graph, part: &Part, about: Vector) -> [Vector; 2] {
        let zero = graph.zero();
        let mut force = graph.zero_vector();
        for (k, &local) in part.locals[..self.model.world.dimension()]
            .iter()
            .enumerate()
        {
            force[k] = self.needed(graph, local);
        }
        let torque = match (part.rotation(), part.representation) {
            (Some(first), _) => {
                let own = [0, 1, 2].map(|k| self.needed(graph, first + k));
                // … and ω × J ω, because the axes turn.
                let omega = [0, 1, 2].map(|k| graph.symbol(Symbol::LocalVelocity(first + k)));
                let spin = part.inertia.map(|row| graph.dot(row, omega));
                let turning = graph.cross(omega, spin);
                let own = graph.vector_add(own, turning);
                graph.turn(&part.frame.axes, own)
            }
            (None, Representation::Reference) => [zero, zero, self.needed(graph, part.locals[2])],
            _ => [zero; 3],
        };
        let offset = graph.turn(&part.frame.axes, part.center);
        let center = center_of(graph, part, offset);
        let arm = graph.vector_sub(center, about);
        let lever = graph.cross(arm, force);
        [force, graph.vector_add(torque, lever)]
    }
}

/// What a joint of the tree transmits: what all parts that it carries need from others.
fn tree_reactions(
    graph: &mut Graph,
    reduction: &mut Substitution,
    balance: &Balance,
    joint: &TreeJoint,
) -> Vec<Reaction> {
    let model = balance.model;
    // What the partner that was declared second is held by, at its own point.
    let (held, sign) = match joint.link.forwards {
        true => (&joint.link.child, 1.0),
        false => (&joint.link.parent, -1.0),
    };
    let about = held.point.position;
    let mut sums = [[graph.zero(); 3]; 2];
    for part in model.tree.carried_by(joint.child) {
        let wrench = balance.wrench(graph, &model.parts[part], about);
        for (sum, part) in sums.iter_mut().zip(wrench) {
            *sum = graph.vector_add(*sum, part);
        }
    }
    let names = [["fx", "fy", "fz"], ["tx", "ty", "tz"]];
    let dimensions = [Dimension::FORCE, Dimension::TORQUE];
    let kinds = if joint.link.free_rotation { 1 } else { 2 };
    let mut reactions = Vec::new();
    for kind in 0..kinds {
        // In the plane there is one torque.
        let (components, names) = match (kind, model.world) {
            (1, World::Planar) => (2..3, ["", "", "torque"]),
            _ => (0..model.world.dimension(), names[kind]),
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

pub(super) fn derive(
    graph: &mut Graph,
    reduction: &mut Substitution,
    joints: &[(String, JointEquations)],
    merged: &[MergedJoint],
    balance: &Balance,
) -> Vec<Reaction> {
    let dimension = balance.model.world.dimension();
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
    for joint in &balance.model.tree.joints {
        reactions.extend(tree_reactions(graph, reduction, balance, joint));
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
