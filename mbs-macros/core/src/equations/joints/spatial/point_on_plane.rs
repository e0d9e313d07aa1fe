//! A point stays on a plane that is fixed in another part.

use super::{Joint, JointEquations, held_across, sliding_points};
use crate::model::{Arguments, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct PointOnPlane {
    point: Point,
    plane: Point,
    normal: Vector,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let (point, plane) = sliding_points(arguments, "plane")?;
    let normal = arguments.home_axis("normal", 2, plane.owner)?;
    Some(Box::new(PointOnPlane {
        point,
        plane,
        normal,
    }))
}

impl Joint for PointOnPlane {
    /// n · (point − plane) = 0; λ n is the force on the point.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        held_across(graph, &self.point, &self.plane, &[("", self.normal)])
    }

    fn points(&self) -> Vec<&Point> {
        vec![&self.point, &self.plane]
    }
}
