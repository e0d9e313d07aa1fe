//! Two points coincide, and the partners turn about one axis.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, JointFrames, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Revolute {
    frames: JointFrames,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    Some(Box::new(Revolute { frames }))
}

impl Joint for Revolute {
    /// d = 0 and z_p · c_y = z_p · c_x = 0.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        Builder::new(graph, &self.frames)
            .coincide()
            .parallel()
            .finish()
    }

    fn link(&self) -> Option<Link> {
        Some(self.frames.link(true, &[], false))
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }

    fn coincident(&self) -> Option<(&Point, &Point)> {
        Some((&self.frames.parent.point, &self.frames.child.point))
    }
}
