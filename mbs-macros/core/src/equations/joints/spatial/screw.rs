//! The child slides along the axis as it turns about it.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, Dimension, JointFrames, Point};
use crate::symbolic::{Expr, Graph};
use std::f64::consts::PI;

#[derive(Debug)]
struct Screw {
    frames: JointFrames,
    angle: Expr,
    stroke: Expr,
    pitch: Expr,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    let pitch = arguments.scalar("pitch")?;
    Some(Box::new(Screw {
        angle: arguments.joint_angle(&frames),
        stroke: arguments.stroke(&frames),
        frames,
        pitch,
    }))
}

impl Joint for Screw {
    /// Cylindrical, and stroke = pitch · angle / 2π; λ is a force along the axis and −λ pitch / 2π a torque about it.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let mut builder = Builder::new(graph, &self.frames)
            .on_plane(0)
            .on_plane(1)
            .parallel();
        let axis = self.frames.parent.axes[2];
        let graph = &mut *builder.graph;
        let lead = graph.scale(0.5 / PI, self.pitch);
        let advance = graph.mul(lead, self.angle);
        let thread = graph.sub(self.stroke, advance);
        let minus = graph.neg(lead);
        let torque = graph.vector_scale(minus, axis);
        let row = builder.push("thread", thread, Dimension::LENGTH);
        builder.acts(row, Some(axis), Some(torque));
        builder.finish()
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }
}
