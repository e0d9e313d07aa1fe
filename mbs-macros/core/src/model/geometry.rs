//! Points, frames and vectors. A plane is the plane z = 0 of space: what is zero there costs nothing, because zeros fold.

use crate::symbolic::{Expr, Function, Graph, Node, Symbol};

/// Components in the ground's axes.
pub type Vector = [Expr; 3];

/// Directions of the three axes of a frame, in the ground's axes.
pub type Axes = [Vector; 3];

/// A symmetric tensor, both triangles.
pub type Tensor = [[Expr; 3]; 3];

/// What a point or frame is fixed to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Owner {
    /// The ground.
    Ground,
    /// A part, by index.
    Part(usize),
}

impl Owner {
    /// The index of the part; `None` for the ground.
    pub fn part(self) -> Option<usize> {
        match self {
            Owner::Ground => None,
            Owner::Part(part) => Some(part),
        }
    }
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
    /// If its components *are* consecutive local coordinates: the first.
    pub free: Option<u32>,
    /// Its name, for example `crank.b`.
    pub label: String,
}

/// A point that is a pair of coordinates, or a place of the ground.
pub(super) fn mergeable(point: &Point) -> bool {
    point.free.is_some() || point.owner == Owner::Ground
}

/// The frame of a part.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Position of the origin.
    pub origin: Vector,
    /// Its axes (of unit length where the constraints hold).
    pub axes: Axes,
    /// Angle of the x axis against ground.x, where it is a coordinate of a planar part (natural coordinates have none).
    pub angle: Option<Expr>,
    /// Angular velocity, in the ground's axes.
    pub spin: Vector,
}

/// A frame fixed in a part: a point with axes.
#[derive(Debug, Clone)]
pub struct Attachment {
    /// Its origin.
    pub point: Point,
    /// Its axes in those of the part; known before the motion starts.
    pub local: Axes,
    /// Its axes in those of the ground.
    pub axes: Axes,
}

impl Graph {
    /// a + b.
    pub fn vector_add(&mut self, a: Vector, b: Vector) -> Vector {
        std::array::from_fn(|k| self.add(a[k], b[k]))
    }

    /// a − b.
    pub fn vector_sub(&mut self, a: Vector, b: Vector) -> Vector {
        std::array::from_fn(|k| self.sub(a[k], b[k]))
    }

    /// s a.
    pub fn vector_scale(&mut self, s: Expr, a: Vector) -> Vector {
        a.map(|a| self.mul(s, a))
    }

    /// a · b.
    pub fn dot(&mut self, a: Vector, b: Vector) -> Expr {
        if let (Some((first, i)), Some((second, j))) = (self.body_axis(a), self.body_axis(b))
            && first == second
        {
            return self.constant(if i == j { 1.0 } else { 0.0 });
        }
        let products = std::array::from_fn::<_, 3, _>(|k| self.mul(a[k], b[k]));
        self.sum(products.to_vec())
    }

    /// The rotation and the column of a vector that is an axis of a body.
    fn body_axis(&self, a: Vector) -> Option<(u32, u8)> {
        let entry = |x: Expr| match self.node(x) {
            Node::Symbol(Symbol::LocalRotation(first, entry)) => Some((*first, *entry)),
            _ => None,
        };
        let (first, column) = entry(a[0])?;
        let is_column = (1..3).all(|row| entry(a[row]) == Some((first, 3 * row as u8 + column)));
        (column < 3 && is_column).then_some((first, column))
    }

    /// a × b.
    pub fn cross(&mut self, a: Vector, b: Vector) -> Vector {
        std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let (first, second) = (self.mul(a[i], b[j]), self.mul(a[j], b[i]));
            self.sub(first, second)
        })
    }

    /// The z component of a × b.
    pub fn planar_cross(&mut self, a: Vector, b: Vector) -> Expr {
        self.cross(a, b)[2]
    }

    /// a turned by +90° in the plane.
    pub fn perpendicular(&mut self, a: Vector) -> Vector {
        [self.neg(a[1]), a[0], self.zero()]
    }

    /// |a|.
    pub fn norm(&mut self, a: Vector) -> Expr {
        let square = self.dot(a, a);
        self.function(Function::Sqrt, square)
    }

    /// a / |a|.
    pub fn unit(&mut self, a: Vector) -> Vector {
        let (one, norm) = (self.one(), self.norm(a));
        let inverse = self.div(one, norm);
        self.vector_scale(inverse, a)
    }

    /// (cos, sin, 0) of an angle.
    pub fn direction(&mut self, angle: Expr) -> Vector {
        [
            self.function(Function::Cos, angle),
            self.function(Function::Sin, angle),
            self.zero(),
        ]
    }

    /// The axes of a planar frame, given its x axis.
    pub fn planar_axes(&mut self, x: Vector) -> Axes {
        [x, self.perpendicular(x), self.ground_axes()[2]]
    }

    /// The axes of the ground.
    pub fn ground_axes(&mut self) -> Axes {
        let (zero, one) = (self.zero(), self.one());
        [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
    }

    /// The zero vector.
    pub fn zero_vector(&mut self) -> Vector {
        [self.zero(); 3]
    }

    /// The rate of a position.
    pub fn vector_rate(&mut self, a: Vector) -> Vector {
        a.map(|a| self.rate(a))
    }

    /// Components given in a frame, turned into the ground's axes.
    pub fn turn(&mut self, axes: &Axes, components: Vector) -> Vector {
        std::array::from_fn(|row| {
            let terms = std::array::from_fn::<_, 3, _>(|k| self.mul(components[k], axes[k][row]));
            self.sum(terms.to_vec())
        })
    }

    /// A vector of the ground's axes in components of a frame.
    pub fn components(&mut self, axes: &Axes, vector: Vector) -> Vector {
        axes.map(|axis| self.dot(axis, vector))
    }

    /// The axes of a frame that is given by its axes in the components of another.
    pub fn compose(&mut self, outer: &Axes, inner: &Axes) -> Axes {
        inner.map(|axis| self.turn(outer, axis))
    }

    /// Axes that are given in a frame, in components of axes of that frame: constants.
    pub(super) fn composed_constants(&mut self, axes: &Axes, given: &Axes) -> Axes {
        given.map(|axis| {
            let components = self.components(axes, axis);
            self.snapped(components)
        })
    }

    /// The components of a vector, if they are numbers.
    pub(super) fn numbers(&self, vector: Vector) -> Option<[f64; 3]> {
        let [x, y, z] = vector.map(|x| self.as_constant(x));
        Some([x?, y?, z?])
    }

    /// A constant direction along an axis, where it is one but for round-off.
    pub(super) fn snapped(&mut self, direction: Vector) -> Vector {
        let Some(numbers) = self.numbers(direction) else {
            return direction;
        };
        numbers.map(|x| {
            let whole = x.round();
            let is_whole = (x - whole).abs() <= 4.0 * f64::EPSILON;
            self.constant(if is_whole { whole } else { x })
        })
    }

    /// Axes turned by an angle about a direction given in their own components (Rodrigues' formula).
    pub fn turned_about(&mut self, axes: &Axes, direction: Vector, angle: Expr) -> Axes {
        let (cos, sin) = (
            self.function(Function::Cos, angle),
            self.function(Function::Sin, angle),
        );
        let one = self.one();
        let rest = self.sub(one, cos);
        let turned = self.ground_axes().map(|axis| {
            let along = self.dot(direction, axis);
            let along = self.mul(rest, along);
            let parts = [
                self.vector_scale(cos, axis),
                self.vector_scale(along, direction),
            ];
            let across = self.cross(direction, axis);
            let across = self.vector_scale(sin, across);
            let sum = self.vector_add(parts[0], parts[1]);
            self.vector_add(sum, across)
        });
        self.compose(axes, &turned)
    }

    /// The point that is `local` in a frame, in the ground's axes.
    pub fn place(&mut self, frame: &Frame, local: Vector) -> Vector {
        let offset = self.turn(&frame.axes, local);
        self.vector_add(frame.origin, offset)
    }
}
