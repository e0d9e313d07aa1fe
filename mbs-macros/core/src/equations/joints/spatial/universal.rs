//! Two points coincide, and two crossed pins, one held by each partner, stay at right angles.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, Dimension, JointFrames, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Universal {
    frames: JointFrames,
    /// The child's pin.
    pin: Vector,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    let (first, second) = (
        arguments.direction("axis")?,
        arguments.direction("second_axis")?,
    );
    let cosine = arguments.graph().dot(first, second);
    let cosine = arguments.by_default(cosine);
    if cosine.abs() > 1e-6 {
        let angle = cosine.clamp(-1.0, 1.0).acos().to_degrees();
        return arguments.fail(
            "second_axis",
            format!(
                "the pins of a universal joint cross at right angles, but these at {angle:.3}°; turn one of them, such as `axis = X, second_axis = Y`"
            ),
        );
    }
    let pin = arguments.fixed_direction(second, frames.child.point.owner);
    Some(Box::new(Universal { frames, pin }))
}

impl Joint for Universal {
    /// d = 0 and z_p · pin = 0; λ pin × z_p is the torque on the child.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        let mut builder = Builder::new(graph, &self.frames).coincide();
        let axis = self.frames.parent.axes[2];
        let cosine = builder.graph.dot(axis, self.pin);
        let row = builder.push("pins", cosine, Dimension::NONE);
        let torque = builder.graph.cross(self.pin, axis);
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
