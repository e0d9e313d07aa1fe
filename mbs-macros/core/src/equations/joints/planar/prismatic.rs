//! The child slides along an axis of the parent and does not turn against it.

use super::alignment::{self, Alignment};
use super::{Joint, JointEquations, across, torque};
use crate::model::{Arguments, Link, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Prismatic {
    parent: Point,
    child: Point,
    axis: Vector,
    alignment: Alignment,
    link: Link,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let alignment = alignment::read(arguments, &parent, &child)?;
    let own = arguments.own_axis("axis")?;
    let axis = arguments.axis("axis", parent.owner)?;
    let link = alignment.link(arguments.graph(), [&parent, &child], Some(own));
    Some(Box::new(Prismatic {
        parent,
        child,
        axis,
        alignment,
        link,
    }))
}

impl Joint for Prismatic {
    /// n · (child − parent) = 0 with n across the axis, and the angle.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let mut equations = across(graph, &self.parent, &self.child, self.axis, "across");
        equations.rows.push(self.alignment.row(graph));
        equations.reactions.push(torque(graph, 1));
        equations
    }

    fn link(&self) -> Option<Link> {
        Some(self.link.clone())
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.parent, &self.child]
    }
}
