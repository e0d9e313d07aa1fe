//! The child slides along the axis and turns about it.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, JointFrames, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Cylindrical {
    frames: JointFrames,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    Some(Box::new(Cylindrical { frames }))
}

impl Joint for Cylindrical {
    /// p_x · d = p_y · d = 0 and z_p · c_y = z_p · c_x = 0.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        Builder::new(graph, &self.frames)
            .on_plane(0)
            .on_plane(1)
            .parallel()
            .finish()
    }

    fn link(&self) -> Option<Link> {
        Some(self.frames.link(true, &[2], false))
    }

    fn points(&self) -> Vec<&Point> {
        partners(&self.frames)
    }
}
