//! The table itself: long, because the language is.

use super::Absent::{Assumed, Required};
use super::Expects::{
    Anything, Axis, Flag, Frame, Known, KnownAny, KnownVector, Law, Moving, MovingAny,
    MovingVector, Part, Point, Unit,
};
use super::{Absent, Expects, Field, Group, Kind};
use crate::model::Dimension;

const fn field(name: &'static str, expects: Expects, default: Absent, doc: &'static str) -> Field {
    Field {
        name,
        positional: false,
        expects,
        default,
        doc,
    }
}

const fn positional(
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
    }
}

const PARENT: Field = positional("parent", Point, Required, "point of the first partner");
const CHILD: Field = positional(
    "child",
    Point,
    Required,
    "point of the second partner; reactions are the forces on it",
);
const FREE: Field = field(
    "free",
    Flag,
    Assumed("false"),
    "says that being connected to nothing is meant",
);
const ANGLE_GUESS: Field = field(
    "angle",
    Known(Dimension::NONE),
    Assumed("0, or what the joints imply"),
    "initial guess of the angle against ground.x",
);
const RATE_GUESS: Field = field(
    "rate",
    Known(Dimension::RATE),
    Assumed("0"),
    "initial guess of the angular velocity",
);
const AT_GUESS: Field = field(
    "at",
    KnownVector(Dimension::LENGTH),
    Assumed("what the joints imply"),
    "initial guess of the position of `origin`",
);
const VELOCITY_GUESS: Field = field(
    "velocity",
    KnownVector(Dimension::VELOCITY),
    Assumed("what the joints imply"),
    "initial guess of the velocity of `origin`",
);
const FRAME: Field = field(
    "frame",
    Frame,
    Assumed("coordinates of its own"),
    "position and angle as expressions of `Coordinate`s: minimal coordinates by hand",
);

/// The worlds.
pub const WORLDS: &[Kind] = &[Kind {
    name: "Planar",
    group: Group::Value,
    fields: &[field(
        "gravity",
        KnownVector(Dimension::ACCELERATION),
        Assumed("[0, 0]"),
        "acceleration of gravity",
    )],
    doc: "Motion in the x–y plane; angles count counter-clockwise from ground.x.",
}];

/// All kinds of entries.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "Param",
        group: Group::Value,
        fields: &[
            positional(
                "value",
                KnownAny,
                Required,
                "default value; its unit fixes the dimension",
            ),
            field(
                "unit",
                Unit,
                Assumed("the unit of the value"),
                "unit of a value written as a bare number",
            ),
        ],
        doc: "A parameter: a public field of the generated struct.",
    },
    Kind {
        name: "Input",
        group: Group::Value,
        fields: &[
            positional(
                "value",
                KnownAny,
                Assumed("0"),
                "value before the program sets one",
            ),
            field(
                "unit",
                Unit,
                Assumed("the unit of the value"),
                "unit of the input",
            ),
        ],
        doc: "A value that the program sets between steps.",
    },
    Kind {
        name: "Let",
        group: Group::Value,
        fields: &[positional("value", Anything, Required, "the expression")],
        doc: "A named expression.",
    },
    Kind {
        name: "Output",
        group: Group::Value,
        fields: &[positional(
            "value",
            Anything,
            Required,
            "the expression; a point or vector gives `name.x` and `name.y`",
        )],
        doc: "A named expression that is sampled with the results.",
    },
    Kind {
        name: "Event",
        group: Group::Value,
        fields: &[positional(
            "value",
            MovingAny,
            Required,
            "the expression whose sign change is the event",
        )],
        doc: "An instant that `run_to_event` can stop at.",
    },
    Kind {
        name: "Point",
        group: Group::Value,
        fields: &[positional(
            "position",
            KnownVector(Dimension::LENGTH),
            Required,
            "position in the ground's axes",
        )],
        doc: "A named point of the ground.",
    },
    Kind {
        name: "Coordinate",
        group: Group::Part,
        fields: &[
            positional(
                "value",
                KnownAny,
                Assumed("0"),
                "initial value; its unit fixes the dimension (an angle by default)",
            ),
            field("rate", KnownAny, Assumed("0"), "initial rate"),
            field(
                "unit",
                Unit,
                Assumed("the unit of the value"),
                "unit of a value written as a bare number",
            ),
        ],
        doc: "A generalized coordinate chosen by hand; parts follow it by `frame =` or `position =`.",
    },
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
            field(
                "from",
                KnownVector(Dimension::LENGTH),
                Assumed("what the joints imply"),
                "initial guess of end `a`",
            ),
            field(
                "to",
                KnownVector(Dimension::LENGTH),
                Assumed("what the joints imply"),
                "initial guess of end `b`",
            ),
            ANGLE_GUESS,
            RATE_GUESS,
            FRAME,
            FREE,
        ],
        doc: "A uniform slender rod with end points `a` and `b`.",
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
            FREE,
        ],
        doc: "A rigid body with a frame at `origin`; points by `body.point(x, y)`.",
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
                MovingVector(Dimension::LENGTH),
                Assumed("coordinates of its own"),
                "position as an expression of `Coordinate`s",
            ),
            FREE,
        ],
        doc: "A point mass; its point is `origin`.",
    },
    Kind {
        name: "Revolute",
        group: Group::Joint,
        fields: &[PARENT, CHILD],
        doc: "The two points coincide. Between ends of bars, particles and the ground they are merged: no coordinate and no row.",
    },
    Kind {
        name: "Prismatic",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            field(
                "axis",
                Axis,
                Assumed("X"),
                "direction of sliding, in the parent's axes",
            ),
            field(
                "angle",
                Known(Dimension::NONE),
                Assumed("0"),
                "angle of the child's frame against the parent's",
            ),
        ],
        doc: "The child slides along an axis of the parent and does not turn against it.",
    },
    Kind {
        name: "Fixed",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            field(
                "angle",
                Known(Dimension::NONE),
                Assumed("0"),
                "angle of the child's frame against the parent's",
            ),
        ],
        doc: "The two points coincide and the frames keep their angle.",
    },
    Kind {
        name: "PointOnLine",
        group: Group::Joint,
        fields: &[
            positional(
                "point",
                Point,
                Required,
                "the point that slides; reactions are the forces on it",
            ),
            positional("line", Point, Required, "a point of the line"),
            field(
                "axis",
                Axis,
                Assumed("X"),
                "direction of the line, in the axes of the line's part",
            ),
        ],
        doc: "A point stays on a line that is fixed in another part.",
    },
    Kind {
        name: "Distance",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            field(
                "length",
                Known(Dimension::LENGTH),
                Required,
                "the distance kept; not zero (use Revolute)",
            ),
        ],
        doc: "Two points keep their distance, as if joined by a massless rod.",
    },
    Kind {
        name: "Gear",
        group: Group::Joint,
        fields: &[
            positional("parent", Part, Required, "the driving part"),
            positional(
                "child",
                Part,
                Required,
                "the driven part; the reaction is the torque on it",
            ),
            field(
                "ratio",
                Known(Dimension::NONE),
                Required,
                "angle of the child per angle of the parent (negative for external gears)",
            ),
            field(
                "offset",
                Known(Dimension::NONE),
                Assumed("0"),
                "angle of the child when the parent's is zero",
            ),
        ],
        doc: "The angles of two parts against the ground keep a ratio.",
    },
    Kind {
        name: "Coupling",
        group: Group::Constraint,
        fields: &[
            positional(
                "first",
                MovingAny,
                Required,
                "a scalar expression of the positions",
            ),
            positional(
                "second",
                MovingAny,
                Required,
                "the expression that follows: second = ratio · first + offset",
            ),
            field("ratio", KnownAny, Assumed("1"), "the ratio"),
            field("offset", KnownAny, Assumed("0"), "the offset"),
        ],
        doc: "Two scalars keep a linear relation.",
    },
    Kind {
        name: "Holonomic",
        group: Group::Constraint,
        fields: &[positional(
            "value",
            Anything,
            Required,
            "expression of positions and time, or a list of them",
        )],
        doc: "The expression is zero.",
    },
    Kind {
        name: "Nonholonomic",
        group: Group::Constraint,
        fields: &[positional(
            "value",
            Anything,
            Required,
            "expression that is affine in the velocities, or a list of them",
        )],
        doc: "The expression is zero.",
    },
    Kind {
        name: "Drive",
        group: Group::Constraint,
        fields: &[
            positional(
                "target",
                MovingAny,
                Required,
                "an angle, length or other expression of the positions",
            ),
            field(
                "value",
                MovingAny,
                Required,
                "its value as a function of `t`",
            ),
        ],
        doc: "Prescribes a position as a function of time.",
    },
    Kind {
        name: "SpringDamper",
        group: Group::Force,
        fields: &[
            PARENT,
            CHILD,
            field(
                "stiffness",
                Known(Dimension::STIFFNESS),
                Assumed("0"),
                "stiffness",
            ),
            field(
                "damping",
                Known(Dimension::DAMPING),
                Assumed("0"),
                "damping",
            ),
            field(
                "length",
                Known(Dimension::LENGTH),
                Assumed("0"),
                "length without force",
            ),
            field(
                "law",
                Law,
                Assumed("none"),
                "tension as a function of [length, rate]; instead of the other fields",
            ),
        ],
        doc: "A spring and damper between two points.",
    },
    Kind {
        name: "TorsionSpring",
        group: Group::Force,
        fields: &[
            positional("parent", Part, Required, "the first partner"),
            positional("child", Part, Required, "the second partner"),
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
                "damping",
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
                "torque against turning as a function of [angle, rate]; instead of the other fields",
            ),
        ],
        doc: "A rotational spring and damper between two parts.",
    },
    Kind {
        name: "Force",
        group: Group::Force,
        fields: &[
            positional("on", Point, Required, "where it acts"),
            field(
                "value",
                MovingVector(Dimension::FORCE),
                Required,
                "its components in the ground's axes",
            ),
        ],
        doc: "A force on a point.",
    },
    Kind {
        name: "Torque",
        group: Group::Force,
        fields: &[
            positional("on", Part, Required, "the part it acts on"),
            field(
                "value",
                Moving(Dimension::TORQUE),
                Required,
                "its value, counter-clockwise",
            ),
            field(
                "from",
                Part,
                Assumed("ground"),
                "the part that feels the reaction",
            ),
        ],
        doc: "A torque on a part.",
    },
];
