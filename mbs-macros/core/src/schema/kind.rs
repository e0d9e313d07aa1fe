//! Kinds of entries and their fields: the columns of the table.

use crate::dimension::Dimension;

/// The worlds, by which kinds differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum World {
    /// Motion in the x–y plane.
    Planar,
    /// Motion in space.
    Spatial,
}

impl World {
    /// Both.
    pub const ALL: [World; 2] = [World::Planar, World::Spatial];

    /// The number of coordinates of a point.
    pub fn dimension(self) -> usize {
        match self {
            World::Planar => 2,
            World::Spatial => 3,
        }
    }

    /// In words.
    pub fn describe(self) -> &'static str {
        match self {
            World::Planar => "the plane",
            World::Spatial => "space",
        }
    }
}

/// A kind of entry.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// Its name, as written.
    pub name: &'static str,
    /// What it declares.
    pub group: Group,
    /// Its fields; those that may be positional come first, in order.
    pub fields: &'static [Field],
    /// One sentence.
    pub doc: &'static str,
    /// Of joints and conditions.
    pub joint: Option<JointTraits>,
}

/// Data of a joint for names and messages, besides its fields.
#[derive(Debug, Clone, Copy)]
pub struct JointTraits {
    /// It has `angle` and `rate`.
    pub turns: bool,
    /// It has `stroke` and `speed`.
    pub slides: bool,
    /// It holds the orientation of its partners, which so have one.
    pub holds_orientation: bool,
    /// It can carry a part in joint coordinates.
    pub carries: bool,
    /// What to write instead in the other world, where it is missing.
    pub elsewhere: &'static str,
    /// Arguments that it has in the other world only.
    pub arguments_elsewhere: &'static [&'static str],
}

impl JointTraits {
    /// No variables; it holds orientations and closes loops.
    pub const NONE: JointTraits = JointTraits {
        turns: false,
        slides: false,
        holds_orientation: true,
        carries: false,
        elsewhere: "",
        arguments_elsewhere: &[],
    };
}

impl Kind {
    /// What is known of a joint; of other kinds nothing.
    pub fn traits(&self) -> JointTraits {
        self.joint.unwrap_or(JointTraits::NONE)
    }
}

/// What an entry declares.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// A number or expression.
    Value,
    /// Something with mass, or a coordinate.
    Part,
    /// A condition between two parts.
    Joint,
    /// A condition written as an expression.
    Constraint,
    /// A force element.
    Force,
}

/// A field of a kind.
#[derive(Debug, Clone, Copy)]
pub struct Field {
    /// Its name; a positional field may be given by name, too.
    pub name: &'static str,
    /// Whether it may be given by position.
    pub positional: bool,
    /// What it takes.
    pub expects: Expects,
    /// What happens when it is left out.
    pub default: Absent,
    /// One line.
    pub doc: &'static str,
    /// Of initial values: what `Exactly(…)` holds.
    pub initial: Option<Initial>,
}

/// An initial value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Initial {
    /// Position of the origin of a part, or of end `a` of a bar.
    Origin,
    /// Position of end `b` of a bar.
    End,
    /// Velocity of the origin.
    Velocity,
    /// Angle of a planar part.
    Angle,
    /// Angular velocity of a planar part.
    Rate,
    /// Angular velocity of a spatial part.
    Spin,
    /// Value of a `Coordinate`.
    Coordinate,
    /// Rate of a `Coordinate`.
    CoordinateRate,
}

/// What a field takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Expects {
    /// A scalar that is known once the parameters are.
    Known(Dimension),
    /// A scalar of any dimension that is known once the parameters are.
    KnownAny,
    /// A vector known once the parameters are.
    KnownVector(Dimension),
    /// A scalar that may change with time, state and inputs.
    Moving(Dimension),
    /// A scalar of any dimension that may change with time, state and inputs.
    MovingAny,
    /// A scalar of any dimension, of time, parameters and inputs.
    ScheduledAny,
    /// A scalar of any dimension, of positions, parameters and time.
    HolonomicAny,
    /// A scalar of any dimension, of positions or velocities; the direction of a bar does for its angle.
    Driven,
    /// A vector that may change with time, state and inputs.
    MovingVector(Dimension),
    /// A scalar of any dimension, of positions and parameters.
    FollowingAny,
    /// A vector of coordinates and parameters.
    FollowingVector(Dimension),
    /// A scalar, a vector, a point, or a list of scalars.
    Anything,
    /// A scalar, a vector or a point.
    Sampled,
    /// A point.
    Point,
    /// A bar, body, or the ground.
    Part,
    /// The same, whose angle is used.
    PartAngle,
    /// A direction: `X`, `Y`, `Z`, or components.
    Axis,
    /// A part together with `at =`, a point, or a frame, to which a spatial joint is attached.
    Attachment,
    /// A joint.
    Joint,
    /// `turn(axis, angle)`, `quaternion(w, x, y, z)`, `axes(x, y)`, a part, or a list of these.
    Orientation,
    /// `Auto`, `Natural`, `Reference` or `Joint`.
    Formulation,
    /// `Cuboid(x, y, z)`, `Cylinder(radius, length, axis)` or `Sphere(radius)`.
    Shape,
    /// A moment of inertia, `diag(…)`, three rows, or a shape.
    Inertia,
    /// A stiffness or damping in six directions: a number of the first dimension (or three, or a matrix of 3 × 3).
    Gains(Dimension),
    /// `Frame([x, y], angle)`.
    Frame,
    /// The path of a function `fn([f64; K]) -> (f64, [f64; K])`: value and partials.
    Law,
    /// A list of numbers and parameters, or a family of parameters.
    Numbers,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A unit, as in `N_per_m`.
    Unit,
    /// `true` or `false`.
    Flag,
    /// A whole number.
    Count,
}

/// What happens when a field is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Absent {
    /// It may not be.
    Required,
    /// This text describes what is assumed.
    Assumed(&'static str),
}

/// A field that is given by its name.
pub const fn field(
    name: &'static str,
    expects: Expects,
    default: Absent,
    doc: &'static str,
) -> Field {
    Field {
        name,
        positional: false,
        expects,
        default,
        doc,
        initial: None,
    }
}

/// A field that may be given by position.
pub const fn positional(
    name: &'static str,
    expects: Expects,
    default: Absent,
    doc: &'static str,
) -> Field {
    Field {
        name,
        positional: true,
        expects,
        default,
        doc,
        initial: None,
    }
}

/// The same field as an initial value, which `Exactly(…)` may hold.
pub const fn initial(held: Initial, field: Field) -> Field {
    Field {
        initial: Some(held),
        ..field
    }
}
