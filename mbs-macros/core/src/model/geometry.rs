//! Points, frames and vectors of the plane.

use crate::symbolic::{Expr, Graph};

/// Components in the ground's axes.
pub type Vector = [Expr; 2];

/// What a point or frame is fixed to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Owner {
    /// The ground.
    Ground,
    /// A part, by index.
    Part(usize),
}

/// A point fixed in a part.
#[derive(Debug, Clone)]
pub struct Point {
    /// Position in the ground's axes, in local coordinates.
    pub position: Vector,
    /// What it is fixed to.
    pub owner: Owner,
    /// Coordinates in its owner's frame.
    pub local: Vector,
    /// If the point *is* a pair of local coordinates: which.
    pub free: Option<[u32; 2]>,
    /// Its name, for example `crank.b`.
    pub label: String,
}

/// The frame of a part.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Position of the origin.
    pub origin: Vector,
    /// Direction of the x axis (of unit length where the constraints hold).
    pub axis: Vector,
    /// Angle against ground.x, where it is a coordinate (natural coordinates have none).
    pub angle: Option<Expr>,
    /// Angular velocity.
    pub rate: Expr,
}

impl Graph {
    /// a + b.
    pub fn vector_add(&mut self, a: Vector, b: Vector) -> Vector {
        [self.add(a[0], b[0]), self.add(a[1], b[1])]
    }

    /// a − b.
    pub fn vector_sub(&mut self, a: Vector, b: Vector) -> Vector {
        [self.sub(a[0], b[0]), self.sub(a[1], b[1])]
    }

    /// s a.
    pub fn vector_scale(&mut self, s: Expr, a: Vector) -> Vector {
        [self.mul(s, a[0]), self.mul(s, a[1])]
    }

    /// a · b.
    pub fn dot(&mut self, a: Vector, b: Vector) -> Expr {
        let (x, y) = (self.mul(a[0], b[0]), self.mul(a[1], b[1]));
        self.add(x, y)
    }

    /// The z component of a × b.
    pub fn cross(&mut self, a: Vector, b: Vector) -> Expr {
        let (first, second) = (self.mul(a[0], b[1]), self.mul(a[1], b[0]));
        self.sub(first, second)
    }

    /// a turned by +90°.
    pub fn perpendicular(&mut self, a: Vector) -> Vector {
        [self.neg(a[1]), a[0]]
    }

    /// |a|.
    pub fn norm(&mut self, a: Vector) -> Expr {
        let square = self.dot(a, a);
        self.function(crate::symbolic::Function::Sqrt, square)
    }

    /// (cos, sin) of an angle.
    pub fn direction(&mut self, angle: Expr) -> Vector {
        use crate::symbolic::Function::{Cos, Sin};
        [self.function(Cos, angle), self.function(Sin, angle)]
    }

    /// The rate of a position.
    pub fn vector_rate(&mut self, a: Vector) -> Vector {
        [self.rate(a[0]), self.rate(a[1])]
    }

    /// Components given in a frame whose x axis is `axis`, turned into the ground's axes.
    pub fn turn(&mut self, axis: Vector, components: Vector) -> Vector {
        let normal = self.perpendicular(axis);
        let (along, across) = (
            self.vector_scale(components[0], axis),
            self.vector_scale(components[1], normal),
        );
        self.vector_add(along, across)
    }
}
