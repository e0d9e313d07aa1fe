//! Conditions that joints of the plane share, with the forces and torques of their multipliers on
//! the child.

use crate::dimension::Dimension;
use crate::model::elements::joint::{Condition, Joint, ReactionComponent};
use crate::model::geometry::{Point, Vector};
use crate::symbolic::Graph;

/// φ = child − parent, two conditions; λ is the force on the child.
pub(super) fn coincidence(graph: &mut Graph, parent: &Point, child: &Point) -> Joint {
    let gap = graph.vector_sub(child.position, parent.position);
    let one = graph.one();
    Joint {
        conditions: vec![
            Condition::position("x", gap[0], Dimension::LENGTH),
            Condition::position("y", gap[1], Dimension::LENGTH),
        ],
        reactions: vec![
            ReactionComponent::force("fx", 0, one),
            ReactionComponent::force("fy", 1, one),
        ],
        points: vec![parent.clone(), child.clone()],
        ..Joint::default()
    }
}

/// n · (child − parent) = 0 with n across `axis`; λ n is the force on the child.
pub(super) fn across(
    graph: &mut Graph,
    parent: &Point,
    child: &Point,
    axis: Vector,
    suffix: &str,
) -> Joint {
    let normal = graph.perpendicular(axis);
    let gap = graph.vector_sub(child.position, parent.position);
    let across = graph.dot(normal, gap);
    Joint {
        conditions: vec![Condition::position(suffix, across, Dimension::LENGTH)],
        reactions: vec![
            ReactionComponent::force("fx", 0, normal[0]),
            ReactionComponent::force("fy", 0, normal[1]),
        ],
        points: vec![parent.clone(), child.clone()],
        ..Joint::default()
    }
}

/// The multiplier of a condition as a torque on the child.
pub(super) fn torque(graph: &mut Graph, condition: usize) -> ReactionComponent {
    ReactionComponent {
        name: "torque",
        dimension: Dimension::TORQUE,
        terms: vec![(condition, graph.one())],
    }
}
