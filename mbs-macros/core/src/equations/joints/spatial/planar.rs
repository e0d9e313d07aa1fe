//! The child slides in the plane across the axis and turns about the axis.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, JointFrames, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Planar {
    frames: JointFrames,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    Some(Box::new(Planar { frames }))
}

impl Joint for Planar {
    /// p_z · d = 0 and z_p · c_y = z_p · c_x = 0.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        Builder::new(graph, &self.frames)
            .on_plane(2)
            .parallel()
            .finish()
    }

    fn link(&self) -> Option<Link> {
        Some(self.frames.link(true, &[0, 1], false))
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }
}
