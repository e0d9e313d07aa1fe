//! The child slides along an axis of the parent and does not turn against it.

use super::alignment::{self, Alignment};
use super::{Joint, JointEquations, ReactionComponent, row, torque};
use crate::model::{Arguments, Dimension, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Prismatic {
    parent: Point,
    child: Point,
    axis: Vector,
    alignment: Alignment,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let alignment = alignment::read(arguments, &parent, &child)?;
    let axis = arguments.axis("axis", parent.owner)?;
    Some(Box::new(Prismatic {
        parent,
        child,
        axis,
        alignment,
    }))
}

impl Joint for Prismatic {
    /// n · (child − parent) = 0 with n across the axis, and the angle.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let normal = graph.perpendicular(self.axis);
        let gap = graph.vector_sub(self.child.position, self.parent.position);
        let across = graph.dot(normal, gap);
        let force = |name, n| ReactionComponent {
            name,
            dimension: Dimension::FORCE,
            terms: vec![(0, n)],
        };
        JointEquations {
            rows: vec![
                row("across", across, Dimension::LENGTH),
                self.alignment.row(graph),
            ],
            reactions: vec![
                force("fx", normal[0]),
                force("fy", normal[1]),
                torque(graph, 1),
            ],
        }
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.parent, &self.child]
    }
}
