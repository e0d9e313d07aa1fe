//! Conditions written as expressions.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, Level, ReactionComponent};
use crate::symbolic::{Expr, Graph, Symbol};

/// Conditions at one level; the reactions are their multipliers.
pub(super) fn joint(
    graph: &mut Graph,
    level: Level,
    list: Vec<(Expr, Option<Dimension>)>,
) -> Joint {
    let one = graph.one();
    let several = list.len() > 1;
    let mut joint = Joint::default();
    for (slot, (expr, dimension)) in list.into_iter().enumerate() {
        let suffix = match several {
            true => format!("[{slot}]"),
            false => String::new(),
        };
        let condition = Condition {
            suffix,
            level,
            expr,
            dimension,
        };
        joint.reactions.push(ReactionComponent {
            name: "lambda",
            dimension: condition.multiplier_dimension(),
            terms: vec![(slot, one)],
        });
        joint.conditions.push(condition);
    }
    joint
}

/// Whether an expression depends on positions.
pub(super) fn moves(arguments: &mut Arguments, expr: Expr) -> bool {
    arguments
        .graph()
        .depends_on(expr, Symbol::is_local_position)
}

/// A condition on positions may not have velocities, inputs, or laws, whose second derivatives are not
/// available.
pub(super) fn check(arguments: &mut Arguments, field: &str) -> Option<()> {
    arguments.refuse(
        field,
        &Symbol::is_velocity,
        "a holonomic condition has no velocities; declare it as `Nonholonomic`, or write the position it integrates to",
    )?;
    arguments.refuse(
        field,
        &|symbol| matches!(symbol, Symbol::Input(_)),
        "a condition on positions cannot follow an input, whose rate is unknown; write it as a function of `t`, use a `Drive`, or let a force follow the input",
    )?;
    arguments.refuse_laws(field)?;
    arguments.refuse_kinks(field, 0)
}
