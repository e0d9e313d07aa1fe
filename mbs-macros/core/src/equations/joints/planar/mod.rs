//! Joints of the plane.

mod alignment;
mod fixed;
mod gear;
mod point_on_line;
mod prismatic;
mod revolute;

use super::{Joint, JointEquations, JointRow, ReactionComponent, affine_relation, row};
use crate::model::{Arguments, Dimension, Point, Vector};
use crate::symbolic::Graph;

/// Reads a joint of the plane.
pub(super) fn read(kind: &str, arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    match kind {
        "Revolute" => revolute::read(arguments),
        "Prismatic" => prismatic::read(arguments),
        "Fixed" => fixed::read(arguments),
        "PointOnLine" => point_on_line::read(arguments),
        "Gear" => gear::read(arguments),
        _ => None,
    }
}

/// φ = child − parent, two rows; λ is the force on the child.
fn coincidence(graph: &mut Graph, parent: &Point, child: &Point) -> JointEquations {
    let gap = graph.vector_sub(child.position, parent.position);
    let one = graph.one();
    let force = |name, row| ReactionComponent {
        name,
        dimension: Dimension::FORCE,
        terms: vec![(row, one)],
    };
    JointEquations {
        rows: vec![
            row("x", gap[0], Dimension::LENGTH),
            row("y", gap[1], Dimension::LENGTH),
        ],
        reactions: vec![force("fx", 0), force("fy", 1)],
    }
}

/// n · (child − parent) = 0 with n across `axis`; λ n is the force on the child.
fn across(
    graph: &mut Graph,
    parent: &Point,
    child: &Point,
    axis: Vector,
    suffix: &str,
) -> JointEquations {
    let normal = graph.perpendicular(axis);
    let gap = graph.vector_sub(child.position, parent.position);
    let across = graph.dot(normal, gap);
    let force = |name, n| ReactionComponent {
        name,
        dimension: Dimension::FORCE,
        terms: vec![(0, n)],
    };
    JointEquations {
        rows: vec![row(suffix, across, Dimension::LENGTH)],
        reactions: vec![force("fx", normal[0]), force("fy", normal[1])],
    }
}

/// The multiplier of row `row` as a torque on the child.
fn torque(graph: &mut Graph, row: usize) -> ReactionComponent {
    ReactionComponent {
        name: "torque",
        dimension: Dimension::TORQUE,
        terms: vec![(row, graph.one())],
    }
}
