//! Two points coincide, and two crossed pins, one held by each partner, stay at right angles.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, Dimension, JointFrames, Link, Point, Vector};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Universal {
    frames: JointFrames,
    /// The child's pin.
    pin: Vector,
    link: Link,
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
    let link = link(arguments, &frames, second);
    Some(Box::new(Universal { frames, pin, link }))
}

/// A turn about the parent's pin z, then one about the child's p: in the home pose the frames are (p, z × p, z), and after
/// the first turn (z × p, z, p).
fn link(arguments: &mut Arguments, frames: &JointFrames, pin: Vector) -> Link {
    let axis = arguments.home_direction(&frames.parent);
    let graph = arguments.graph();
    let across = graph.cross(axis, pin);
    let [x, y, z] = graph.ground_axes();
    Link {
        parent: arguments.reattached(&frames.parent, [pin, across, axis]),
        child: arguments.reattached(&frames.child, [across, axis, pin]),
        turns: true,
        second: Some([y, z, x]),
        offset: None,
        slides: Vec::new(),
        free_rotation: false,
        forwards: true,
    }
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

    fn link(&self) -> Option<Link> {
        Some(self.link.clone())
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }

    fn coincident(&self) -> Option<(&Point, &Point)> {
        Some((&self.frames.parent.point, &self.frames.child.point))
    }
}
