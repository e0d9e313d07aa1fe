//! Kinds that the plane and space share.

use super::kind::Absent::{Assumed, Required};
use super::kind::Expects::{
    Anything, Count, Flag, Formulation, Known, KnownAny, KnownVector, Law, MovingAny, MovingVector,
    Numbers, Part, Point, Sampled, Unit, Word,
};
use super::kind::{Field, Group, Initial, Kind, field, initial, positional};
use crate::dimension::Dimension;

/// Of joints.
pub const PARENT: Field = positional("parent", Point, Required, "point of the first partner");
/// Of joints.
pub const CHILD: Field = positional(
    "child",
    Point,
    Required,
    "point of the second partner; reactions are the forces on it",
);
pub(super) const COORDINATES: Field = field(
    "coordinates",
    Formulation,
    Assumed("Auto"),
    "which coordinates describe the mechanism",
);
pub(super) const BUDGET: Field = field(
    "budget",
    Count,
    Assumed("100000"),
    "the most statements of generated Rust; more is an error",
);
pub(super) const OWN_COORDINATES: Field = field(
    "coordinates",
    Formulation,
    Assumed("those of the mechanism"),
    "which coordinates describe this part",
);
pub(super) const FREE: Field = field(
    "free",
    Flag,
    Assumed("false"),
    "says that being connected to nothing is meant",
);

/// The kinds.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "Param",
        group: Group::Value,
        fields: &[
            positional(
                "value",
                KnownAny,
                Required,
                "default value; its unit fixes the dimension. With `nominal =` the path of a constant of Rust, an `f64` in SI units",
            ),
            field(
                "nominal",
                KnownAny,
                Assumed("the value"),
                "of a constant: about its value, with its unit; the compiler, which does not know the constant, checks with it",
            ),
            field(
                "unit",
                Unit,
                Assumed("the unit of the value"),
                "unit of a value written as a bare number",
            ),
        ],
        doc: "A parameter: a public field of the generated struct. `Param([1.0_N, 2.0_N])` is a family with these defaults: an array.",
        joint: None,
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
        joint: None,
    },
    Kind {
        name: "Let",
        group: Group::Value,
        fields: &[positional("value", Anything, Required, "the expression")],
        doc: "A named expression.",
        joint: None,
    },
    Kind {
        name: "Table",
        group: Group::Value,
        fields: &[
            positional(
                "arguments",
                Numbers,
                Required,
                "at least two, increasing; their unit is that of x in `name(x)`; parameters among them are data of each mechanism",
            ),
            positional(
                "values",
                Numbers,
                Required,
                "one for each argument, of the same sorts; their unit is that of `name(x)`",
            ),
            field(
                "interpolation",
                Word(&["Cubic", "Linear"]),
                Assumed("Cubic"),
                "between the arguments: monotone cubic polynomials, whose slope is continuous, or straight lines",
            ),
            field(
                "beyond",
                Word(&["Linear", "Constant", "Periodic"]),
                Assumed("Linear"),
                "outside them: the slope or the value at the end goes on (`Cubic` meets a constant value with slope 0), or, with `Periodic`, the curve is repeated; its period is the distance from the first to the last argument, at which the values are equal",
            ),
        ],
        doc: "A function of one number, from measured values: `name(x)` in an expression, or `law = name` in a spring.",
        joint: None,
    },
    Kind {
        name: "Output",
        group: Group::Value,
        fields: &[positional(
            "value",
            Sampled,
            Required,
            "the expression; a point or vector gives `name.x` and `name.y`",
        )],
        doc: "A named expression that is sampled with the results.",
        joint: None,
    },
    Kind {
        name: "State",
        group: Group::Value,
        fields: &[
            field(
                "rate",
                MovingAny,
                Required,
                "how fast it changes: an expression of what moves, of `t`, inputs, tables and states, itself among them",
            ),
            field(
                "initial",
                KnownAny,
                Assumed("0"),
                "its value at the start; its unit fixes the dimension",
            ),
            field(
                "unit",
                Unit,
                Assumed("the unit of the initial value"),
                "unit of an initial value written as a bare number",
            ),
            field(
                "scale",
                KnownAny,
                Assumed("the initial value or, where that is 0, 1 in SI units"),
                "a usual size: errors of the state are relative to its value, or to this where it is less",
            ),
        ],
        doc: "A value with a rate of its own, such as the integral of a controller; it has no mass and no energy, and is sampled with the outputs.",
        joint: None,
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
        joint: None,
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
        joint: None,
    },
    Kind {
        name: "Coordinate",
        group: Group::Part,
        fields: &[
            initial(
                Initial::Coordinate,
                positional(
                    "value",
                    KnownAny,
                    Assumed("0"),
                    "initial value; its unit fixes the dimension (an angle by default)",
                ),
            ),
            initial(
                Initial::CoordinateRate,
                field("rate", KnownAny, Assumed("0"), "initial rate"),
            ),
            field(
                "unit",
                Unit,
                Assumed("the unit of the value"),
                "unit of a value written as a bare number",
            ),
        ],
        doc: "A generalized coordinate chosen by hand; parts follow it by `frame =` or `position =`.",
        joint: None,
    },
    Kind {
        name: "SpringDamper",
        group: Group::Force,
        fields: &[
            PARENT,
            positional("child", Point, Required, "point of the second partner"),
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
                "damping, or a table of tension over rate",
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
                "tension as a function of [length, rate], and of p and q in `law = name(p, q)`, instead of the other fields; or a table of tension over elongation, instead of `stiffness`",
            ),
        ],
        doc: "A spring and damper between two points.",
        joint: None,
    },
    Kind {
        name: "Force",
        group: Group::Force,
        fields: &[
            positional(
                "on",
                Point,
                Required,
                "where it acts, or a joint that slides",
            ),
            field(
                "value",
                MovingVector(Dimension::FORCE),
                Required,
                "its components; in a joint its value along the joint's axis",
            ),
            field(
                "axes",
                Part,
                Assumed("ground"),
                "the part in whose axes the components are given",
            ),
        ],
        doc: "A force on a point, or in a joint: on its child, and back on its parent.",
        joint: None,
    },
];
