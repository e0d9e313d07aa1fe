//! The ground and the parts: their names, coordinates, frames and points.

use super::Local;
use super::geometry::{Frame, Owner, Point};
use super::parts::Representation;
use super::resolver::Resolver;
use crate::symbolic::{Expr, Symbol};

impl Resolver<'_> {
    /// A new local coordinate.
    pub(super) fn local(&mut self, name: String, unit: &str) -> u32 {
        let index = self.locals.len() as u32;
        self.graph
            .set_name(Symbol::LocalPosition(index), name.clone());
        self.graph
            .set_name(Symbol::LocalVelocity(index), format!("{name}'"));
        self.locals.push(Local {
            name,
            unit: unit.to_owned(),
        });
        index
    }

    /// Whether this is a point with mass, which has no orientation.
    pub(super) fn is_particle(&self, owner: Owner) -> bool {
        matches!(owner, Owner::Part(part) if self.parts[part].kind == "Particle")
    }

    /// The frame of the ground or of a part.
    pub(super) fn frame(&mut self, owner: Owner) -> Frame {
        match owner {
            Owner::Part(part) => self.parts[part].frame.clone(),
            Owner::Ground => {
                let zero = self.graph.zero();
                Frame {
                    origin: [zero; 3],
                    axes: self.graph.ground_axes(),
                    angle: Some(zero),
                    spin: [zero; 3],
                }
            }
        }
    }

    pub(super) fn owner_name(&self, owner: Owner) -> &str {
        match owner {
            Owner::Ground => "ground",
            Owner::Part(part) => &self.parts[part].name,
        }
    }

    pub(super) fn bar_length(&self, owner: Owner) -> Option<Expr> {
        match owner {
            Owner::Ground => None,
            Owner::Part(part) => self.parts[part].length,
        }
    }

    /// The points that have a name in a part.
    pub(super) fn point_names(&self, owner: Owner) -> &'static [&'static str] {
        match owner {
            Owner::Ground => &["origin"],
            Owner::Part(part) => match self.parts[part].kind {
                "Bar" => &["a", "b", "center"],
                "Body" => &["origin", "center"],
                _ => &["origin"],
            },
        }
    }

    /// `crank.a`, `ground.origin`, ….
    pub(super) fn named_point(&mut self, owner: Owner, name: &str) -> Option<Point> {
        if !self.point_names(owner).contains(&name) {
            return None;
        }
        let label = format!("{}.{name}", self.owner_name(owner));
        let zero = self.graph.zero();
        let Owner::Part(index) = owner else {
            return Some(self.point_of(owner, [zero; 3], label));
        };
        let part = &self.parts[index];
        let dimension = self.world.dimension();
        let free = match (&part.representation, name) {
            (Representation::Natural | Representation::FreePoint, "a" | "origin") => {
                Some(part.locals[0])
            }
            (Representation::Natural, "b") => Some(part.locals[dimension]),
            _ => None,
        };
        let length = part.length.unwrap_or(zero);
        let local = match name {
            "b" => [length, zero, zero],
            "center" if part.kind == "Bar" => [self.graph.scale(0.5, length), zero, zero],
            "center" => part.center,
            _ => [zero; 3],
        };
        let mut point = self.point_of(owner, local, label);
        if let Some(first) = free {
            point.position = self.free_position(first);
            point.free = Some(first);
        }
        Some(point)
    }
}
