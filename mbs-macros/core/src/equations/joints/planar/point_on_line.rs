//! A point stays on a line that is fixed in another part.

use super::{Joint, JointEquations, across};
use crate::model::{Arguments, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct PointOnLine {
    point: Point,
    line: Point,
    axis: Vector,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (point, line) = (arguments.point("point"), arguments.point("line"));
    let (point, line) = (point?, line?);
    if point.owner == line.owner {
        let owner = arguments.owner_name(point.owner);
        return arguments.fail(
            "line",
            format!("the point and the line both belong to `{owner}`"),
        );
    }
    let axis = arguments.axis("axis", line.owner)?;
    Some(Box::new(PointOnLine { point, line, axis }))
}

impl Joint for PointOnLine {
    /// n · (point − line) = 0 with n across the line; λ n is the force on the point.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        across(graph, &self.line, &self.point, self.axis, "")
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.line, &self.point]
    }
}
