//! The kinds of space.

use super::common::{COORDINATES, FREE, OWN_COORDINATES};
use super::kind::Absent::{Assumed, Required};
use super::kind::Expects::{
    Attachment, Axis, Gains, Inertia, Joint, Known, KnownVector, Law, MovingVector, Orientation,
    Part, Point, Shape,
};
use super::kind::{Field, Group, Kind, field, positional};
use crate::dimension::Dimension;

const PARENT: Field = positional("parent", Attachment, Required, "the first partner");
const CHILD: Field = positional(
    "child",
    Attachment,
    Required,
    "the second partner; reactions are the forces and torques on it",
);
const AT: Field = field(
    "at",
    KnownVector(Dimension::LENGTH),
    Assumed("the points of the partners"),
    "where the joint is in the home pose, in the ground's axes",
);
const AXIS: Field = field(
    "axis",
    Axis,
    Assumed("Z, or the z axes of the partners' frames"),
    "its axis in the home pose, in the ground's axes",
);
const HOME: Field = field(
    "at",
    KnownVector(Dimension::LENGTH),
    Assumed("[0, 0, 0]"),
    "position of `origin` in the home pose, which is also the initial guess",
);
const VELOCITY: Field = field(
    "velocity",
    KnownVector(Dimension::VELOCITY),
    Assumed("what the joints imply"),
    "initial guess of the velocity of `origin`",
);
const SPIN: Field = field(
    "angular_velocity",
    KnownVector(Dimension::RATE),
    Assumed("[0, 0, 0]"),
    "initial guess of the angular velocity, in the ground's axes",
);
const STIFFNESS: Field = field(
    "stiffness",
    Known(Dimension::TORQUE),
    Assumed("0"),
    "stiffness per radian",
);
const DAMPING: Field = field(
    "damping",
    Known(Dimension::TORSION_DAMPING),
    Assumed("0"),
    "damping",
);

/// The world.
pub(super) const WORLD: Kind = Kind {
    name: "Spatial",
    group: Group::Value,
    fields: &[
        field(
            "gravity",
            KnownVector(Dimension::ACCELERATION),
            Assumed("[0, 0, 0]"),
            "acceleration of gravity",
        ),
        COORDINATES,
    ],
    doc: "Motion in space. The pose in which parts are declared, by `at`, `orientation`, `from` and `to`, is the home pose: there joints are given by `at` and `axis`, and there the motion starts.",
};

/// A joint of two partners by place and axis.
const fn joint(name: &'static str, doc: &'static str) -> Kind {
    Kind {
        name,
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT, AXIS],
        doc,
    }
}

/// The kinds.
pub(super) const KINDS: &[Kind] = &[
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
                Assumed("[0, 0, 0]"),
                "position of end `a` in the home pose",
            ),
            field(
                "to",
                KnownVector(Dimension::LENGTH),
                Assumed("`length` from `a` along X"),
                "position of end `b` in the home pose",
            ),
            field(
                "radius",
                Known(Dimension::LENGTH),
                Assumed("slender: its end points are its coordinates"),
                "radius of a round bar",
            ),
            field(
                "inertia",
                Inertia,
                Assumed("that of a slender or round bar"),
                "inertia about the centre of mass, x along the bar",
            ),
            VELOCITY,
            SPIN,
            OWN_COORDINATES,
            FREE,
        ],
        doc: "A uniform straight bar from `a` to `b`, x along it; for a bar along X, Y or Z the axes y and z are the next of the ground's, in that order and round again. A slender one has no inertia about itself and no orientation that a joint could hold, only its end points.",
    },
    Kind {
        name: "Body",
        group: Group::Part,
        fields: &[
            field("mass", Known(Dimension::MASS), Required, "mass"),
            field(
                "inertia",
                Inertia,
                Required,
                "inertia about the centre of mass, in the body's axes",
            ),
            field(
                "center_of_mass",
                KnownVector(Dimension::LENGTH),
                Assumed("[0, 0, 0]"),
                "centre of mass in the body's axes, from `origin`",
            ),
            HOME,
            field(
                "orientation",
                Orientation,
                Assumed("the ground's axes"),
                "orientation in the home pose",
            ),
            VELOCITY,
            SPIN,
            field(
                "shape",
                Shape,
                Assumed("that of the inertia, if it is one"),
                "what an animation draws about the centre of mass",
            ),
            OWN_COORDINATES,
            FREE,
        ],
        doc: "A rigid body with a frame at `origin`; points by `body.point(x, y, z)`, frames by `body.frame([x, y, z], axis)`.",
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
            HOME,
            VELOCITY,
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
    joint(
        "Revolute",
        "Two points coincide and the partners turn about one axis: 5 rows. It has `angle` and `rate`.",
    ),
    joint(
        "Prismatic",
        "The child slides along the axis and does not turn: 5 rows. It has `stroke` and `speed`.",
    ),
    joint(
        "Cylindrical",
        "The child slides along the axis and turns about it: 4 rows. It has `angle`, `rate`, `stroke` and `speed`.",
    ),
    Kind {
        name: "Spherical",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT],
        doc: "Two points coincide: 3 rows. Between ends of slender bars, particles and the ground they are merged: no coordinate and no row.",
    },
    Kind {
        name: "Universal",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            AT,
            field(
                "axis",
                Axis,
                Required,
                "the pin held by the parent, in the home pose",
            ),
            field(
                "second_axis",
                Axis,
                Required,
                "the pin held by the child, in the home pose; across the first",
            ),
        ],
        doc: "Two points coincide and two crossed pins stay at right angles: 4 rows.",
    },
    joint(
        "ConstantVelocity",
        "Two points coincide and the shafts, along the axis where they are aligned, turn at the same rate whatever their angle: 4 rows.",
    ),
    joint(
        "Planar",
        "The child slides in the plane across the axis and turns about the axis: 3 rows. It has `angle` and `rate`.",
    ),
    Kind {
        name: "Fixed",
        group: Group::Joint,
        fields: &[PARENT, CHILD, AT],
        doc: "The child neither moves nor turns against the parent: 6 rows.",
    },
    Kind {
        name: "Screw",
        group: Group::Joint,
        fields: &[
            PARENT,
            CHILD,
            AT,
            AXIS,
            field(
                "pitch",
                Known(Dimension::LENGTH),
                Required,
                "stroke per turn; negative for a left-hand thread",
            ),
        ],
        doc: "The child slides along the axis as it turns about it: 5 rows. It has `angle`, `rate`, `stroke` and `speed`.",
    },
    Kind {
        name: "Gear",
        group: Group::Joint,
        fields: &[
            positional("first", Joint, Required, "the driving joint, which turns"),
            positional(
                "second",
                Joint,
                Required,
                "the driven joint; the reaction is the torque in it",
            ),
            field(
                "ratio",
                Known(Dimension::NONE),
                Required,
                "angle of the second per angle of the first",
            ),
            field(
                "offset",
                Known(Dimension::NONE),
                Assumed("0"),
                "angle of the second where that of the first is zero",
            ),
        ],
        doc: "The angles of two joints keep a ratio: 1 row.",
    },
    Kind {
        name: "RackPinion",
        group: Group::Joint,
        fields: &[
            positional("pinion", Joint, Required, "the joint that turns"),
            positional(
                "rack",
                Joint,
                Required,
                "the joint that slides; the reaction is the force along it",
            ),
            field(
                "radius",
                Known(Dimension::LENGTH),
                Required,
                "stroke of the rack per radian of the pinion",
            ),
            field(
                "offset",
                Known(Dimension::LENGTH),
                Assumed("0"),
                "stroke where the angle is zero",
            ),
        ],
        doc: "A rack moves as a pinion turns: 1 row.",
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
                "direction of the line in the home pose, in the ground's axes",
            ),
        ],
        doc: "A point stays on a line that is fixed in another part: 2 rows.",
    },
    Kind {
        name: "PointOnPlane",
        group: Group::Joint,
        fields: &[
            positional(
                "point",
                Point,
                Required,
                "the point that slides; reactions are the forces on it",
            ),
            positional("plane", Point, Required, "a point of the plane"),
            field(
                "normal",
                Axis,
                Assumed("Z"),
                "normal of the plane in the home pose, in the ground's axes",
            ),
        ],
        doc: "A point stays on a plane that is fixed in another part: 1 row.",
    },
    Kind {
        name: "TorsionSpring",
        group: Group::Force,
        fields: &[
            positional("joint", Joint, Required, "a joint that turns"),
            STIFFNESS,
            DAMPING,
            field(
                "angle",
                Known(Dimension::NONE),
                Assumed("0"),
                "angle without torque",
            ),
            field(
                "law",
                Law,
                Assumed("none"),
                "torque against turning as a function of [angle, rate]; instead of the other fields",
            ),
        ],
        doc: "A rotational spring and damper in a joint.",
    },
    Kind {
        name: "Bushing",
        group: Group::Force,
        fields: &[
            PARENT,
            CHILD,
            AT,
            field(
                "stiffness",
                Gains(Dimension::STIFFNESS),
                Assumed("0"),
                "against displacement, in the parent's axes: a number, three of them, or a 3 × 3 matrix",
            ),
            field(
                "damping",
                Gains(Dimension::DAMPING),
                Assumed("0"),
                "against velocity, likewise",
            ),
            field(
                "torsion_stiffness",
                Gains(Dimension::TORQUE),
                Assumed("0"),
                "against turning, per radian, likewise",
            ),
            field(
                "torsion_damping",
                Gains(Dimension::TORSION_DAMPING),
                Assumed("0"),
                "against angular velocity, likewise",
            ),
            field(
                "cross_stiffness",
                Gains(Dimension::FORCE),
                Assumed("0"),
                "force against turning and torque against displacement: the block of a 6 × 6 stiffness beside its diagonal blocks",
            ),
        ],
        doc: "An elastic joint: springs and dampers in all six directions, relaxed in the home pose. Turning is measured by 2 sin(ψ/2) about its axis, which is the angle where it is small.",
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
                MovingVector(Dimension::TORQUE),
                Required,
                "its components in the ground's axes; in a joint its value about the joint's axis",
            ),
            field(
                "from",
                Part,
                Assumed("ground"),
                "the part that feels the reaction",
            ),
            field(
                "axes",
                Part,
                Assumed("ground"),
                "the part in whose axes the components are given",
            ),
        ],
        doc: "A torque on a part, or in a joint.",
    },
    Kind {
        name: "Wrench",
        group: Group::Force,
        fields: &[
            positional("on", Point, Required, "where it acts"),
            field(
                "force",
                MovingVector(Dimension::FORCE),
                Assumed("[0, 0, 0]"),
                "components of the force",
            ),
            field(
                "torque",
                MovingVector(Dimension::TORQUE),
                Assumed("[0, 0, 0]"),
                "components of the torque",
            ),
            field(
                "axes",
                Part,
                Assumed("ground"),
                "the part in whose axes the components are given",
            ),
        ],
        doc: "A force and a torque on a point of a body.",
    },
];
