//! A point stays on a line that is fixed in another part.

use super::{Joint, JointEquations, held_across, sliding_points};
use crate::model::{Arguments, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct PointOnLine {
    point: Point,
    line: Point,
    /// Two directions across the line.
    normals: [Vector; 2],
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (point, line) = sliding_points(arguments, "line")?;
    let axis = match arguments.has("axis") {
        true => arguments.direction("axis")?,
        false => arguments.graph().ground_axes()[0],
    };
    let [x, y, _] = arguments.axes_along(axis);
    let normals = [x, y].map(|normal| arguments.fixed_direction(normal, line.owner));
    Some(Box::new(PointOnLine {
        point,
        line,
        normals,
    }))
}

impl Joint for PointOnLine {
    /// n · (point − line) = 0 for two directions across the line; λ n is the force on the point.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let [u, v] = self.normals;
        held_across(graph, &self.point, &self.line, &[("u", u), ("v", v)])
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.point, &self.line]
    }
}
