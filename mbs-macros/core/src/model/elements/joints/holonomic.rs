//! φ(q, t) = 0, written as an expression.

use super::conditions;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Joint, Level};
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Holonomic",
        group: Group::Constraint,
        fields: &[positional(
            "value",
            Expects::Anything,
            Absent::Required,
            "expression of positions and time, or a list of them",
        )],
        doc: "The expression is zero.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    conditions::check(arguments, "value")?;
    let found = arguments.conditions("value")?;
    for &(span, expr, _) in &found {
        if !conditions::moves(arguments, expr) {
            return arguments.fail_at(
                span,
                "this condition does not depend on any position: nothing could fulfil it",
            );
        }
    }
    let list = found.into_iter();
    let list = list.map(|(_, expr, dimension)| (expr, dimension)).collect();
    Some(conditions::joint(arguments.graph(), Level::Position, list))
}
