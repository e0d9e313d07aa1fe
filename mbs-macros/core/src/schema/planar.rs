//! The kinds of the plane.

use super::common::{BUDGET, COORDINATES, FREE, OWN_COORDINATES};
use super::kind::Absent::{Assumed, Required};
use super::kind::Expects::{
    FollowingVector, Frame, Known, KnownVector, Law, Moving, Part, PartAngle,
};
use super::kind::{Field, Group, Initial, Kind, field, initial, positional};
use crate::dimension::Dimension;

const AT_GUESS: Field = initial(
    Initial::Origin,
    field(
        "at",
        KnownVector(Dimension::LENGTH),
        Assumed("what the joints imply"),
        "initial guess of the position of `origin`",
    ),
);
const VELOCITY_GUESS: Field = initial(
    Initial::Velocity,
    field(
        "velocity",
        KnownVector(Dimension::VELOCITY),
        Assumed("what the joints imply"),
        "initial guess of the velocity of `origin`",
    ),
);
const ANGLE_GUESS: Field = initial(
    Initial::Angle,
    field(
        "angle",
        Known(Dimension::NONE),
        Assumed("0, or what the joints imply"),
        "initial guess of the angle against ground.x",
    ),
);
const RATE_GUESS: Field = initial(
    Initial::Rate,
    field(
        "rate",
        Known(Dimension::RATE),
        Assumed("0"),
        "initial guess of the angular velocity",
    ),
);
const FRAME: Field = field(
    "frame",
    Frame,
    Assumed("coordinates of its own"),
    "position and angle as expressions of `Coordinate`s: minimal coordinates by hand",
);

/// The world.
pub const WORLD: Kind = Kind {
    name: "Planar",
    group: Group::Value,
    fields: &[
        field(
            "gravity",
            KnownVector(Dimension::ACCELERATION),
            Assumed("[0, 0]"),
            "acceleration of gravity",
        ),
        COORDINATES,
        BUDGET,
    ],
    doc: "Motion in the x–y plane; angles count counter-clockwise from ground.x.",
    joint: None,
};

/// The kinds.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "Bar",
        group: Group::Part,
        fields: &[
            field(
                "mass",
                Known(Dimension::MASS),
                Assumed("0, massless"),
                "mass, uniformly distributed",
            ),
            field(
                "length",
                Known(Dimension::LENGTH),
                Assumed("the distance from `from` to `to`"),
                "distance of its end points `a` and `b`",
            ),
            initial(
                Initial::Origin,
                field(
                    "from",
                    KnownVector(Dimension::LENGTH),
                    Assumed("what the joints imply"),
                    "initial guess of end `a`",
                ),
            ),
            initial(
                Initial::End,
                field(
                    "to",
                    KnownVector(Dimension::LENGTH),
                    Assumed("what the joints imply"),
                    "initial guess of end `b`",
                ),
            ),
            ANGLE_GUESS,
            RATE_GUESS,
            FRAME,
            OWN_COORDINATES,
            FREE,
        ],
        doc: "A uniform slender rod with end points `a` and `b`.",
        joint: None,
    },
    Kind {
        name: "Body",
        group: Group::Part,
        fields: &[
            field("mass", Known(Dimension::MASS), Required, "mass"),
            field(
                "inertia",
                Known(Dimension::INERTIA),
                Required,
                "moment of inertia about the centre of mass",
            ),
            field(
                "center_of_mass",
                KnownVector(Dimension::LENGTH),
                Assumed("[0, 0]"),
                "centre of mass in the body's axes, from `origin`",
            ),
            AT_GUESS,
            ANGLE_GUESS,
            VELOCITY_GUESS,
            RATE_GUESS,
            FRAME,
            OWN_COORDINATES,
            FREE,
        ],
        doc: "A rigid body with a frame at `origin`; points by `body.point(x, y)`.",
        joint: None,
    },
    Kind {
        name: "Particle",
        group: Group::Part,
        fields: &[
            field(
                "mass",
                Known(Dimension::MASS),
                Assumed("0, massless"),
                "mass",
            ),
            AT_GUESS,
            VELOCITY_GUESS,
            field(
                "position",
                FollowingVector(Dimension::LENGTH),
                Assumed("coordinates of its own"),
                "position as an expression of `Coordinate`s",
            ),
            FREE,
        ],
        doc: "A point mass; its point is `origin`.",
        joint: None,
    },
    Kind {
        name: "TorsionSpring",
        group: Group::Force,
        fields: &[
            positional(
                "parent",
                PartAngle,
                Required,
                "the first partner, or a joint that turns",
            ),
            positional(
                "child",
                PartAngle,
                Assumed("that of the joint"),
                "the second partner",
            ),
            field(
                "stiffness",
                Known(Dimension::TORQUE),
                Assumed("0"),
                "stiffness per radian",
            ),
            field(
                "damping",
                Known(Dimension::TORSION_DAMPING),
                Assumed("0"),
                "damping, or a table of torque over rate",
            ),
            field(
                "angle",
                Known(Dimension::NONE),
                Assumed("0"),
                "angle of the child against the parent without torque",
            ),
            field(
                "law",
                Law,
                Assumed("none"),
                "torque against turning as a function of [angle, rate], and of p and q in `law = name(p, q)`, instead of the other fields; or a table of torque over turning, instead of `stiffness`",
            ),
        ],
        doc: "A rotational spring and damper between two parts, or in a joint.",
        joint: None,
    },
    Kind {
        name: "Torque",
        group: Group::Force,
        fields: &[
            positional(
                "on",
                Part,
                Required,
                "the part it acts on, or a joint that turns",
            ),
            field(
                "value",
                Moving(Dimension::TORQUE),
                Required,
                "its value, counter-clockwise; in a joint on its child",
            ),
            field(
                "from",
                Part,
                Assumed("ground"),
                "the part that feels the reaction",
            ),
        ],
        doc: "A torque on a part, or in a joint.",
        joint: None,
    },
];
