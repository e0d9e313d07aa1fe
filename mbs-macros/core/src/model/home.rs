//! The home pose: where the declaration puts spatial parts. The motion starts there, and joints are given there.

use super::geometry::{Owner, Point, Vector};
use super::parts::Home;
use super::resolver::Resolver;

/// How far apart points may be in the home pose, relative to the size of the mechanism: assembly closes such gaps.
pub(super) const NEARLY_TOGETHER: f64 = 1e-2;

impl Resolver<'_> {
    /// Where the ground or a part is in the home pose, in parameters.
    pub(super) fn home(&mut self, owner: Owner) -> Home {
        let ground = Home {
            origin: self.graph.zero_vector(),
            axes: self.graph.ground_axes(),
        };
        match owner {
            Owner::Ground => ground,
            Owner::Part(part) => self.parts[part].home.unwrap_or(ground),
        }
    }

    /// What a point stands for in an expression: where it is, now or in the home pose.
    pub(super) fn position(&mut self, point: &Point) -> Vector {
        match self.in_home_pose {
            true => self.home_of(point),
            false => point.position,
        }
    }

    /// The axes of a part, now or in the home pose.
    pub(super) fn axes(&mut self, owner: Owner) -> [Vector; 3] {
        match self.in_home_pose {
            true => self.home(owner).axes,
            false => self.frame(owner).axes,
        }
    }

    /// Where a point is in the home pose.
    pub(super) fn home_of(&mut self, point: &Point) -> Vector {
        let home = self.home(point.owner);
        let offset = self.graph.turn(&home.axes, point.local);
        self.graph.vector_add(home.origin, offset)
    }
}
