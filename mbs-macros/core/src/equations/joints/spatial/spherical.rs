//! Two points coincide.

use super::{Builder, Joint, JointEquations, partners};
use crate::model::{Arguments, JointFrames, Link, Point};
use crate::symbolic::Graph;

#[derive(Debug)]
struct Spherical {
    frames: JointFrames,
    /// The partners' points as they were given, where they were: ends of slender bars can be merged.
    points: Option<(Point, Point)>,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    let frames = arguments.own_frames()?;
    let points = match arguments.has("at") {
        true => None,
        false => arguments.given_points(),
    };
    Some(Box::new(Spherical { frames, points }))
}

impl Joint for Spherical {
    /// d = 0.
    fn equations(&self, graph: &mut Graph) -> JointEquations {
        Builder::new(graph, &self.frames).coincide().finish()
    }

    fn link(&self) -> Option<Link> {
        Some(self.frames.link(false, &[], true))
    }

    fn points(&self) -> Vec<&Point> {
        match &self.points {
            Some((parent, child)) => vec![parent, child],
            None => partners(&self.frames),
        }
    }

    fn coincident(&self) -> Option<(&Point, &Point)> {
        Some((&self.frames.parent.point, &self.frames.child.point))
    }

    fn merges(&self) -> Option<(&Point, &Point)> {
        self.points.as_ref().map(|(parent, child)| (parent, child))
    }
}
