//! A spring and damper between two points.

use super::{Action, Characteristic, Force};
use crate::model::{Arguments, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct SpringDamper {
    parent: Point,
    child: Point,
    characteristic: Characteristic,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let characteristic = Characteristic::read(arguments, "length");
    let (parent, child) = (parent?, child?);
    if parent.owner == child.owner {
        let owner = arguments.owner_name(parent.owner);
        return arguments.fail(
            "child",
            format!("both points belong to `{owner}`: the element cannot change its length"),
        );
    }
    Some(Box::new(SpringDamper {
        parent,
        child,
        characteristic: characteristic?,
    }))
}

impl Force for SpringDamper {
    fn action(&self, graph: &mut Graph) -> Action {
        let difference = graph.vector_sub(self.child.position, self.parent.position);
        let length = graph.norm(difference);
        let rate = graph.rate(length);
        self.characteristic.action(graph, length, rate)
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.parent, &self.child]
    }
}
