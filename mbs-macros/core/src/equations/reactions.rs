//! Joint reactions.
//!
//! A joint with rows transmits what its multipliers say. A joint that the reduction dissolved has no multiplier; what it
//! transmits is what the ends on the child's side need from their surroundings: inertia minus everything else that acts
//! on them, taken in the parts' own coordinates, where the ends are still apart. The multiplier of a row that was solved
//! is what the coordinate needs that followed from it.

use super::forces::Load;
use super::inertia::{LocalMass, center_of};
use super::joints::JointEquations;
use super::{Reaction, Row, multipliers};
use crate::model::{Dimension, MergedJoint, Model, Part, Representation, TreeJoint, Vector};
use crate::schema::World;
use crate::symbolic::{Expr, Graph, Substitution, Symbol};

/// Everything that acts on the parts, in their own coordinates.
pub(super) struct Balance<'a> {
    pub inertia: &'a LocalMass,
    pub potential: Expr,
    pub loads: &'a [Load],
    pub rows: &'a [Row],
    /// Rows that were solved, in local coordinates.
    pub solved: &'a [Expr],
    pub model: &'a Model,
}

impl Balance<'_> {
    /// The force that local coordinate `local` needs from joints without rows: M s̈ + ∂V/∂s − Q − Aᵀλ.
    fn needed(&self, graph: &mut Graph, local: u32) -> Expr {
        let mut terms = vec![self.unsolved(graph, local)];
        for (index, &row) in self.solved.iter().enumerate() {
            let slope = graph.derivative(row, Symbol::LocalPosition(local));
            let multiplier = graph.symbol(self.multiplier(index));
            let force = graph.mul(slope, multiplier);
            terms.push(graph.neg(force));
        }
        graph.sum(terms)
    }

    /// The multiplier of a row that was solved: it is counted after those of all other rows.
    fn multiplier(&self, solved: usize) -> Symbol {
        Symbol::Multiplier((self.rows.len() + solved) as u32)
    }

    /// The same, and what it needs from rows that were solved.
    fn unsolved(&self, graph: &mut Graph, local: u32) -> Expr {
        let mut terms = vec![self.convective(graph, local)];
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

    /// Ṁ ṡ − ∂T/∂s, where mass depends on position.
    fn convective(&self, graph: &mut Graph, local: u32) -> Expr {
        let speed = |graph: &mut Graph, local| graph.symbol(Symbol::LocalVelocity(local));
        let mut terms = Vec::new();
        for (&(i, j), &mass) in self.inertia {
            let slope = graph.derivative(mass, Symbol::LocalPosition(local));
            if !graph.is_zero(slope) {
                let speeds = [i, j].map(|local| speed(graph, local));
                let square = graph.mul(speeds[0], speeds[1]);
                let energy = graph.mul(slope, square);
                terms.push(graph.scale(-0.5, energy));
            }
            if i == local {
                let (rate, speed) = (graph.rate(mass), speed(graph, j));
                terms.push(graph.mul(rate, speed));
            }
        }
        graph.sum(terms)
    }

    /// ω × J ω of a part that turns in space, in its axes.
    fn turning(&self, graph: &mut Graph, part: &Part, first: u32) -> Vector {
        let omega = [0, 1, 2].map(|k| graph.symbol(Symbol::LocalVelocity(first + k)));
        let spin = part.inertia.map(|row| graph.dot(row, omega));
        graph.cross(omega, spin)
    }

    /// The multipliers of the rows that were solved: of what the coordinates need that followed from them, as much as each
    /// row moves them by.
    fn recovered(&self, graph: &mut Graph) -> Vec<Expr> {
        let coordinates = &self.model.solved.coordinates;
        let mut sums: Vec<Vec<Expr>> = vec![Vec::new(); coordinates.len()];
        for coordinate in coordinates {
            let needed = self.needed_along(graph, coordinate.local);
            for (terms, &answer) in sums.iter_mut().zip(&coordinate.answers) {
                terms.push(graph.mul(answer, needed));
            }
        }
        sums.into_iter().map(|terms| graph.sum(terms)).collect()
    }

    /// What all that moved with a coordinate, before it followed from others, needs from the rows that were solved.
    fn needed_along(&self, graph: &mut Graph, coordinate: u32) -> Expr {
        let along = Symbol::LocalVelocity(coordinate);
        let mut terms = Vec::new();
        for part in &self.model.parts {
            let turning = part.rotation().map(|first| {
                let turning = self.turning(graph, part, first);
                (first, turning)
            });
            for &local in &part.locals {
                let own = Symbol::LocalVelocity(local);
                let rate = match self.model.solved.merged.get(own) {
                    Some(rate) => rate,
                    None => graph.symbol(own),
                };
                let slope = graph.derivative(rate, along);
                if graph.is_zero(slope) {
                    continue;
                }
                let mut needed = self.unsolved(graph, local);
                if let Some((first, turning)) = turning
                    && local >= first
                {
                    needed = graph.add(needed, turning[(local - first) as usize]);
                }
                terms.push(graph.mul(slope, needed));
            }
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
                let turning = self.turning(graph, part, first);
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
    for (index, multiplier) in balance.recovered(graph).into_iter().enumerate() {
        let multiplier = graph.substitute(multiplier, reduction);
        reduction.insert(balance.multiplier(index), multiplier);
    }
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
    let indices = multipliers(joints, balance.model, balance.rows.len());
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
                .filter_map(|&(row, coefficient)| {
                    let index = indices.get(&(joint, row))?;
                    let multiplier = graph.symbol(Symbol::Multiplier(*index));
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
