//! Two points coincide, and the partners turn about their axes at the same rate whatever the angle between these.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, Dimension, JointFrames, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct ConstantVelocity {
    frames: JointFrames,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    Some(Box::new(ConstantVelocity { frames }))
}

impl Joint for ConstantVelocity {
    /// d = 0 and ½ (p_x · c_y − p_y · c_x) = 0: the one rotation that leads from p to c is about an axis across both
    /// shafts, so that the plane of contact halves the angle between them.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let mut builder = Builder::new(graph, &self.frames).coincide();
        let (p, c) = (self.frames.parent.axes, self.frames.child.axes);
        let graph = &mut *builder.graph;
        let (first, second) = (graph.dot(p[0], c[1]), graph.dot(p[1], c[0]));
        let twist = graph.linear(0.0, &[(first, 0.5), (second, -0.5)]);
        let torques = [graph.cross(c[1], p[0]), graph.cross(c[0], p[1])];
        let torque = std::array::from_fn(|k| {
            graph.linear(0.0, &[(torques[0][k], 0.5), (torques[1][k], -0.5)])
        });
        let row = builder.push("twist", twist, Dimension::NONE);
        builder.acts(row, None, Some(torque));
        builder.finish()
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }

    fn coincident(&self) -> Option<(&Point, &Point)> {
        Some((&self.frames.parent.point, &self.frames.child.point))
    }
}
