//! Two points coincide and their frames keep their angle.

use super::alignment::{self, Alignment};
use super::{Joint, JointEquations, coincidence, torque};
use crate::model::{Arguments, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Fixed {
    parent: Point,
    child: Point,
    alignment: Alignment,
    link: Link,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    let alignment = alignment::read(arguments, &parent, &child)?;
    let link = alignment.link(arguments.graph(), [&parent, &child], None);
    Some(Box::new(Fixed {
        parent,
        child,
        alignment,
        link,
    }))
}

impl Joint for Fixed {
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let mut equations = coincidence(graph, &self.parent, &self.child);
        equations.rows.push(self.alignment.row(graph));
        equations.reactions.push(torque(graph, 2));
        equations
    }

    fn link(&self) -> Option<Link> {
        Some(self.link.clone())
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.parent, &self.child]
    }

    fn coincident(&self) -> Option<(&Point, &Point)> {
        Some((&self.parent, &self.child))
    }
}
