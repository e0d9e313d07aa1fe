//! Two points coincide.

use super::{Joint, JointEquations, coincidence};
use crate::model::{Arguments, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Revolute {
    parent: Point,
    child: Point,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    if parent.owner == child.owner {
        let owner = arguments.owner_name(parent.owner);
        return arguments.fail(
            "child",
            format!("both points belong to `{owner}`: a joint holds two different parts"),
        );
    }
    Some(Box::new(Revolute { parent, child }))
}

impl Joint for Revolute {
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        coincidence(graph, &self.parent, &self.child)
    }

    fn link(&self) -> Option<Link> {
        Some(Link::of_points(&self.parent, &self.child))
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.parent, &self.child]
    }

    fn coincident(&self) -> Option<(&Point, &Point)> {
        Some((&self.parent, &self.child))
    }

    fn merges(&self) -> Option<(&Point, &Point)> {
        Some((&self.parent, &self.child))
    }
}
