//! Stops, which the plane and space share.

use super::kind::Absent::{Assumed, Required};
use super::kind::Expects::{FollowingAny, KnownAny};
use super::kind::{Group, Kind, field, positional};

/// The kinds.
pub const KINDS: &[Kind] = &[Kind {
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
}];
