//! Two scalars keep a linear relation.

use super::{conditions, relation};
use crate::diagnostics::Place;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, Level, ReactionComponent};
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Coupling",
        group: Group::Constraint,
        fields: &[
            positional(
                "first",
                Expects::HolonomicAny,
                Absent::Required,
                "the expression that leads",
            ),
            positional(
                "second",
                Expects::HolonomicAny,
                Absent::Required,
                "the expression that follows: second = ratio · first + offset",
            ),
            field(
                "ratio",
                Expects::KnownAny,
                Absent::Assumed("1"),
                "the ratio",
            ),
            field(
                "offset",
                Expects::KnownAny,
                Absent::Assumed("0"),
                "the offset",
            ),
        ],
        doc: "Two scalars keep a linear relation.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    conditions::check(arguments, "first")?;
    conditions::check(arguments, "second")?;
    let (first, from) = arguments.quantity("first")?;
    let (second, to) = arguments.quantity("second")?;
    for (field, expr) in [("first", first), ("second", second)] {
        if !conditions::moves(arguments, expr) {
            return arguments.fail(
                field,
                "this does not depend on any position: a coupling takes two expressions that move",
            );
        }
    }
    let (ratio, offset) = (
        arguments.scalar_or("ratio", 1.0)?,
        arguments.scalar_or("offset", 0.0)?,
    );
    if let (Some(from), Some(to), false) = (from, to, arguments.has("ratio"))
        && from != to
    {
        return arguments.fail(
            "second",
            format!("this is {to}, but the first is {from}; give a `ratio =` with its unit"),
        );
    }
    if arguments.has("ratio")
        && let (Some((_, Some(unit))), Some(from), Some(to)) =
            (arguments.quantity("ratio"), from, to)
        && unit.times(from) != to
    {
        return arguments.fail(
            "ratio",
            format!("the ratio takes {from} to {to}: it is {}", to.over(from)),
        );
    }
    if let (Some(syntax), Some(wanted)) = (arguments.syntax("offset"), to)
        && let Some((_, found)) = arguments.quantity("offset")
    {
        arguments.check_dimension("offset", found, wanted, Place::of(syntax))?;
    }
    let graph = arguments.graph();
    let condition = Condition {
        suffix: String::new(),
        level: Level::Position,
        expr: relation::affine(graph, first, second, ratio, offset),
        dimension: to,
    };
    let reaction = ReactionComponent {
        name: "lambda",
        dimension: condition.multiplier_dimension(),
        terms: vec![(0, graph.one())],
    };
    Some(Joint {
        conditions: vec![condition],
        reactions: vec![reaction],
        ..Joint::default()
    })
}
