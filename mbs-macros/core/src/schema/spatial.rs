//! The kinds of space.

use super::common::{BUDGET, COORDINATES, FREE, OWN_COORDINATES};
use super::kind::Absent::{Assumed, Required};
use super::kind::Expects::{
    Attachment, Axis, FollowingVector, Gains, Inertia, Joint, Known, KnownVector, Law,
    MovingVector, Orientation, Part, Point, Shape,
};
use super::kind::{Field, Group, Initial, Kind, field, initial, positional};
use crate::dimension::Dimension;

/// Of joints.
pub const PARENT: Field = positional("parent", Attachment, Required, "the first partner");
/// Of joints.
pub const CHILD: Field = positional(
    "child",
    Attachment,
    Required,
    "the second partner; reactions are the forces and torques on it",
);
/// Of joints.
pub const AT: Field = field(
    "at",
    KnownVector(Dimension::LENGTH),
    Assumed("the points of the partners"),
    "where the joint is in the home pose, in the ground's axes; points of parts are those of the home pose",
);
/// Of joints.
pub const AXIS: Field = field(
    "axis",
    Axis,
    Assumed("Z, or the z axes of the partners' frames"),
    "its axis in the home pose, in the ground's axes",
);
const HOME: Field = initial(
    Initial::Origin,
    field(
        "at",
        KnownVector(Dimension::LENGTH),
        Assumed("[0, 0, 0]"),
        "position of `origin` in the home pose, which is also the initial guess; or a point of another part",
    ),
);
const VELOCITY: Field = initial(
    Initial::Velocity,
    field(
        "velocity",
        KnownVector(Dimension::VELOCITY),
        Assumed("what the joints imply"),
        "initial guess of the velocity of `origin`",
    ),
);
const SPIN: Field = initial(
    Initial::Spin,
    field(
        "angular_velocity",
        KnownVector(Dimension::RATE),
        Assumed("[0, 0, 0]"),
        "initial guess of the angular velocity, in the ground's axes",
    ),
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
    "damping, or a table of torque over rate",
);

/// The world.
pub const WORLD: Kind = Kind {
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
        BUDGET,
    ],
    doc: "Motion in space. The pose in which parts are declared, by `at`, `orientation`, `from` and `to`, is the home pose: there joints are given by `at` and `axis`, and there the motion starts.",
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
                    Assumed("[0, 0, 0]"),
                    "position of end `a` in the home pose; points of other parts are those of the home pose",
                ),
            ),
            initial(
                Initial::End,
                field(
                    "to",
                    KnownVector(Dimension::LENGTH),
                    Assumed("`length` from `a` along X"),
                    "position of end `b` in the home pose; points of other parts are those of the home pose",
                ),
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
        joint: None,
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
            HOME,
            VELOCITY,
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
                "torque against turning as a function of [angle, rate], and of p and q in `law = name(p, q)`, instead of the other fields; or a table of torque over turning, instead of `stiffness`",
            ),
        ],
        doc: "A rotational spring and damper in a joint.",
        joint: None,
    },
    Kind {
        name: "Bushing",
        group: Group::Force,
        fields: &[
            PARENT,
            positional("child", Attachment, Required, "the second partner"),
            AT,
            field(
                "stiffness",
                Gains(Dimension::STIFFNESS),
                Assumed("0"),
                "against displacement, in the parent's axes, or those of a frame that is given: a number, three of them, or a 3 × 3 matrix",
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
        doc: "An elastic joint: springs and dampers in all six directions, relaxed in the home pose. Turning is measured by 2 sin(ψ/2) about its axis, beside displacements by sin ψ: both are the angle where it is small.",
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
        joint: None,
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
        joint: None,
    },
];
