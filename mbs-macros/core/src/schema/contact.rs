//! Stops and friction, which the plane and space share.

use super::kind::Absent::{Assumed, Required};
use super::kind::Expects::{FollowingAny, Known, KnownAny, MovingAny};
use super::kind::{Group, Kind, field, positional};
use crate::dimension::Dimension;

/// The kinds.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "Stop",
        group: Group::Force,
        fields: &[
            positional(
                "target",
                FollowingAny,
                Required,
                "an angle, a length, a distance",
            ),
            field(
                "lower",
                KnownAny,
                Assumed("no stop below"),
                "where the stop below begins",
            ),
            field(
                "upper",
                KnownAny,
                Assumed("no stop above"),
                "where the stop above begins",
            ),
            field(
                "stiffness",
                KnownAny,
                Required,
                "stiffness of a stop; N m, per radian, for an angle",
            ),
            field(
                "onset",
                KnownAny,
                Required,
                "depth over which the stiffness grows from zero, in the unit of the target",
            ),
            field(
                "dissipation",
                KnownAny,
                Assumed("0"),
                "damping force per elastic force and rate (Hunt and Crossley), s/m or, for an angle, s",
            ),
        ],
        doc: "Elastic stops of an angle, length or distance. They only push.",
        joint: None,
    },
    Kind {
        name: "Friction",
        group: Group::Force,
        fields: &[
            positional(
                "speed",
                MovingAny,
                Required,
                "the speed of sliding or the rate of turning, against which the friction acts",
            ),
            field(
                "load",
                MovingAny,
                Required,
                "the normal force; where the speed is a rate, normal force times radius",
            ),
            field(
                "coefficient",
                Known(Dimension::NONE),
                Required,
                "kinetic coefficient of friction",
            ),
            field(
                "static_coefficient",
                Known(Dimension::NONE),
                Assumed("`coefficient`"),
                "coefficient of friction at the onset of sliding",
            ),
            field(
                "stribeck_velocity",
                KnownAny,
                Assumed("none, without `static_coefficient`"),
                "speed v with which the difference of the coefficients decays, by exp(−(speed/v)²)",
            ),
            field(
                "regularization_velocity",
                KnownAny,
                Required,
                "speed v within which the sign of the friction changes, by tanh(speed/v)",
            ),
            field(
                "damping",
                KnownAny,
                Assumed("0"),
                "viscous part: force per speed",
            ),
        ],
        doc: "Coulomb friction with the Stribeck effect and a viscous part, smooth at zero speed: the parts creep, they do not stick.",
        joint: None,
    },
];
