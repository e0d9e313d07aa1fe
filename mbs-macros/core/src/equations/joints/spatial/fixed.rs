//! The child neither moves nor turns against the parent.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, JointFrames, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Fixed {
    frames: JointFrames,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    Some(Box::new(Fixed { frames }))
}

impl Joint for Fixed {
    /// d = 0, and all axes stay square to the others.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        Builder::new(graph, &self.frames)
            .coincide()
            .parallel()
            .square(0, 1)
            .finish()
    }

    fn link(&self) -> Option<Link> {
        Some(self.frames.link(false, &[], false))
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }

    fn coincident(&self) -> Option<(&Point, &Point)> {
        Some((&self.frames.parent.point, &self.frames.child.point))
    }
}
