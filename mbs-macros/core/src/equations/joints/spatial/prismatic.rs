//! The child slides along the axis and does not turn.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, JointFrames, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Prismatic {
    frames: JointFrames,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    Some(Box::new(Prismatic { frames }))
}

impl Joint for Prismatic {
    /// p_x · d = p_y · d = 0, and all axes stay square to the others.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        Builder::new(graph, &self.frames)
            .on_plane(0)
            .on_plane(1)
            .parallel()
            .square(0, 1)
            .finish()
    }

    fn link(&self) -> Option<Link> {
        Some(self.frames.link(false, &[2], false))
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }
}
