//! The two frames of a joint, one on each partner. In space they coincide in the home pose, with z along the joint's
//! axis; in the plane they have the axes of the partners.

use super::geometry::{Attachment, Owner, Point, Vector};
use super::mobilizer::{Freedom, Mobilizer};

/// The two frames of a joint.
#[derive(Debug, Clone)]
pub struct JointFrames {
    /// The joint's name.
    pub name: String,
    /// Its kind.
    pub kind: String,
    /// It has an angle about its axis.
    pub turns: bool,
    /// It has a stroke along its axis.
    pub slides: bool,
    /// The direction of the stroke, fixed in the parent, in the ground's axes.
    pub along: Vector,
    /// On the first partner.
    pub parent: Attachment,
    /// On the second.
    pub child: Attachment,
    /// Names of the axes: those of the ground where they are such in the home pose, else `u`, `v`, `w`.
    pub letters: [&'static str; 3],
}

impl JointFrames {
    /// A joint that leaves these motions free between its frames.
    pub fn mobilizer(&self, freedoms: impl Into<Vec<Freedom>>) -> Mobilizer {
        Mobilizer::new(&self.parent, &self.child, freedoms)
    }

    /// The origins of both.
    pub fn origins(&self) -> [Point; 2] {
        [self.parent.point.clone(), self.child.point.clone()]
    }

    /// The same as a list.
    pub fn points(&self) -> Vec<Point> {
        self.origins().to_vec()
    }

    /// The partners.
    pub fn owners(&self) -> [Owner; 2] {
        [self.parent.point.owner, self.child.point.owner]
    }
}
