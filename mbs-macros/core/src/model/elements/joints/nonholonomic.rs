//! N(q) v + n(q, t) = 0, written as an expression.

use super::conditions;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Joint, Level};
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, positional};
use crate::symbolic::Symbol;

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Nonholonomic",
        group: Group::Constraint,
        fields: &[positional(
            "value",
            Expects::Anything,
            Absent::Required,
            "expression that is affine in the velocities, or a list of them",
        )],
        doc: "The expression is zero.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    arguments.refuse_laws("value")?;
    arguments.refuse_kinks("value", 1)?;
    let found = arguments.conditions("value")?;
    for &(span, expr, _) in &found {
        let graph = arguments.graph();
        if !graph.depends_on(expr, Symbol::is_velocity) {
            return arguments.fail_at(span, "a nonholonomic condition needs velocities; a condition on positions is `Holonomic`");
        }
        if !graph.is_affine_in_velocities(expr) {
            return arguments.fail_at(
                span,
                "a nonholonomic condition must be affine in the velocities: N(q) v + n(q, t) = 0",
            );
        }
    }
    let list = found.into_iter();
    let list = list.map(|(_, expr, dimension)| (expr, dimension)).collect();
    Some(conditions::joint(arguments.graph(), Level::Velocity, list))
}
