//! The home pose: where the declaration puts spatial parts. The motion starts there, and joints are given there.

use super::geometry::{Owner, Point, Vector};
use super::parts::{Home, Part, Representation};
use super::resolver::Resolver;
use crate::symbolic::{Expr, Substitution, Symbol};

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

    /// The value in the home pose of an expression of coordinates, such as the place of a particle that follows them.
    pub(super) fn in_home_pose_of(&mut self, position: Vector) -> Vector {
        let mut known = Substitution::nameless();
        for symbol in self.graph.symbols(position) {
            let value = match symbol {
                Symbol::LocalPosition(local) => self.home_coordinate(local),
                Symbol::LocalRotation(first, entry) => self.home_rotation(first, entry),
                _ => None,
            };
            if let Some(value) = value {
                known.insert(symbol, value);
            }
        }
        position.map(|x| self.graph.substitute(x, &mut known))
    }

    /// An entry of the rotation whose first local is this, in the home pose.
    pub(super) fn home_rotation(&self, first: u32, entry: u8) -> Option<Expr> {
        let (row, column) = (usize::from(entry / 3), usize::from(entry % 3));
        let mut parts = self.parts.iter();
        let part = parts.find(|part| part.rotation() == Some(first))?;
        part.home.map(|home| home.axes[column][row])
    }

    /// The value of a local coordinate in the home pose.
    fn home_coordinate(&mut self, local: u32) -> Option<Expr> {
        let mut parts = self.parts.iter();
        let (part, place): (&Part, usize) = parts.find_map(|part| {
            let place = part.locals.iter().position(|&own| own == local)?;
            Some((part, place))
        })?;
        let zero = self.graph.zero();
        if part.representation.is_number() {
            return Some(part.guess.angle.unwrap_or(zero));
        }
        let (home, center, length) = (part.home?, part.center, part.length.unwrap_or(zero));
        let inside = match (part.representation, place / 3) {
            (Representation::Rigid, 0) => center,
            (Representation::Natural, 1) => [length, zero, zero],
            _ => [zero; 3],
        };
        let arm = self.graph.turn(&home.axes, inside);
        let place_of_point = self.graph.vector_add(home.origin, arm);
        place_of_point.get(place % 3).copied()
    }
}
