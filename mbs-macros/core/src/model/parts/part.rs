//! A bar, body, particle or declared coordinate, as data.

use super::shape::Shape;
use crate::model::formulation::Formulation;
use crate::model::geometry::{Axes, Frame, Point, Tensor, Vector};
use crate::symbolic::{Expr, Function, Graph, Symbol};
use proc_macro2::Span;

/// How a part is modelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Representation {
    /// Two end points as coordinates.
    Natural,
    /// Centre of mass and angle.
    Reference,
    /// Centre of mass and unit quaternion.
    Rigid,
    /// A point.
    FreePoint,
    /// Follows `Coordinate`s.
    Prescribed,
    /// A declared coordinate; parts follow it.
    Coordinate,
    /// The integral of a state over time.
    State,
}

impl Representation {
    /// In words.
    pub fn describe(self) -> &'static str {
        match self {
            Representation::Natural => "natural coordinates (its end points)",
            Representation::Reference => "reference coordinates (centre of mass and angle)",
            Representation::Rigid => {
                "reference coordinates (centre of mass and unit quaternion; angular velocity in body axes)"
            }
            Representation::FreePoint => "its point",
            Representation::Prescribed => "follows declared coordinates",
            Representation::Coordinate => "a declared coordinate",
            Representation::State => "a state",
        }
    }

    /// Whether it is a number, without a place or a frame.
    pub fn is_number(self) -> bool {
        matches!(self, Representation::Coordinate | Representation::State)
    }

    /// Whether its coordinates are components of points, which joints may merge.
    pub fn is_points(self) -> bool {
        matches!(self, Representation::Natural | Representation::FreePoint)
    }
}

/// A bar, body or particle.
#[derive(Debug, Clone)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its kind.
    pub kind: &'static str,
    /// Where it is declared.
    pub span: Span,
    /// How it is modelled.
    pub representation: Representation,
    /// `coordinates =` of its own.
    pub formulation: Option<Formulation>,
    /// Its coordinates; a rotation counts as three.
    pub locals: Vec<u32>,
    /// Mass.
    pub mass: Expr,
    /// Inertia about the centre of mass, in the part's axes; a planar part has the last entry only.
    pub inertia: Tensor,
    /// Length of a bar.
    pub length: Option<Expr>,
    /// Centre of mass in the part's axes, from its origin.
    pub center: Vector,
    /// Its frame.
    pub frame: Frame,
    /// Declared guesses.
    pub guess: Guess,
    /// Where it is in the home pose, in parameters; for spatial parts.
    pub home: Option<Home>,
    /// What it looks like.
    pub shape: Option<Shape>,
    /// `free = true`.
    pub free: bool,
}

/// A declared place at the start.
#[derive(Debug, Clone)]
pub enum StartPlace {
    /// In parameters.
    Known(Vector),
    /// That of a point of a part of the plane, which is where the joints take it. (Parts of space have a home pose.)
    Of(Point),
}

impl StartPlace {
    /// The position, in parameters or in local coordinates.
    pub fn position(&self) -> Vector {
        match self {
            StartPlace::Known(position) => *position,
            StartPlace::Of(point) => point.position,
        }
    }
}

/// Declared guesses of a part's start; what is no place is in parameters.
#[derive(Debug, Clone, Default)]
pub struct Guess {
    /// Position of the origin.
    pub origin: Option<StartPlace>,
    /// Position of the far end of a bar.
    pub end: Option<StartPlace>,
    /// Velocity of the origin.
    pub velocity: Option<Vector>,
    /// Angle.
    pub angle: Option<Expr>,
    /// Angular velocity.
    pub rate: Option<Expr>,
    /// Angular velocity of a spatial part.
    pub spin: Option<Vector>,
}

/// A pose in parameters.
#[derive(Debug, Clone, Copy)]
pub struct Home {
    /// Position of the origin.
    pub origin: Vector,
    /// Axes.
    pub axes: Axes,
}

impl Part {
    /// The first local of its rotation, for a rigid part.
    pub fn rotation(&self) -> Option<u32> {
        (self.representation == Representation::Rigid).then(|| self.locals[3])
    }

    /// The velocity of the centre of mass in the axes of a rigid part, marked (see [`Function::Same`]): joints that carry
    /// the part know it without a rotation.
    pub fn own_velocity(&self, graph: &mut Graph) -> Vector {
        let velocity = [0, 1, 2].map(|k| graph.symbol(Symbol::LocalVelocity(self.locals[k])));
        let own = graph.components(&self.frame.axes, velocity);
        own.map(|x| graph.function(Function::Same, x))
    }
}
